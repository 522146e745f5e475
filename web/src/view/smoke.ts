import {
  Color, Group, InstancedBufferAttribute, InstancedBufferGeometry, Matrix4, Mesh, PlaneGeometry, ShaderMaterial, UniformsLib, UniformsUtils,
  Vector3,
} from 'three';
import type { Motion } from '../motion';
import type { Replica } from '../protocol/replica';
import type { Light, Scene } from '../protocol/scene';
import { bodyMatrix } from './frames';
import { sunOf } from './surfaces';

const kSlices = { within: 12, onMap: 4 }; // few enough for software renderers
const kOnMap = 0.9; // brightness in map view

// View-aligned slices through the box's bounding sphere.
const kVertex = `
  attribute float slice;  // 0: the farthest
  uniform mat4 toWorld;
  uniform vec3 halfSize;
  uniform float slices;
  varying vec3 within;
  #include <fog_pars_vertex>
  void main() {
    float reach = length(halfSize);
    vec4 mvPosition = viewMatrix * toWorld * vec4(0.0, 0.0, 0.0, 1.0);
    mvPosition.xyz += reach * vec3(2.4 * position.xy, (2.0 * slice + 1.0) / slices - 1.0);
    within = (inverse(viewMatrix * toWorld) * mvPosition).xyz / halfSize;
    gl_Position = projectionMatrix * mvPosition;
    #include <fog_vertex>
  }`;

// Two octaves of noise drifting up, fading towards the box's sides (as in playhouse/render/shaders.cc).
const kFragment = `
  uniform vec3 halfSize, color;
  uniform float opacity, seconds, bright, slices;
  varying vec3 within;
  #include <fog_pars_fragment>
  float hash(vec3 p) {
    p = fract(p * vec3(0.1031, 0.1030, 0.0973));
    p += dot(p, p.yxz + 33.33);
    return fract((p.x + p.y) * p.z);
  }
  float noise(vec3 p) {
    vec3 i = floor(p), f = fract(p);
    f = f * f * (3.0 - 2.0 * f);
    vec4 along;
    along.x = mix(hash(i), hash(i + vec3(1, 0, 0)), f.x);
    along.y = mix(hash(i + vec3(0, 1, 0)), hash(i + vec3(1, 1, 0)), f.x);
    along.z = mix(hash(i + vec3(0, 0, 1)), hash(i + vec3(1, 0, 1)), f.x);
    along.w = mix(hash(i + vec3(0, 1, 1)), hash(i + vec3(1, 1, 1)), f.x);
    vec2 up = mix(along.xz, along.yw, f.y);
    return mix(up.x, up.y, f.z);
  }
  void main() {
    float inside = 1.0 - dot(within, within);
    if (inside <= 0.0) discard;
    vec3 q = within * halfSize * 2.2 - vec3(0.0, 0.0, 0.35 * seconds);
    float grain = 0.6 * noise(q) + 0.4 * noise(2.6 * q);
    float density = clamp(2.5 * (inside + 1.6 * grain - 1.1), 0.0, 1.0) * min(1.0, 3.0 * inside);
    float thickness = -log(max(1.0 - opacity, 0.002)) / max(min(halfSize.x, halfSize.y), 0.05);
    float hides = 1.0 - exp(-density * thickness * 2.0 * length(halfSize) / slices);
    gl_FragColor = vec4(color * bright, hides);
    #include <colorspace_fragment>
    #include <fog_fragment>
  }`;

/** Smoke clouds in the boxes of their models, as view-aligned slices drawn back to front. */
export class Smoke {
  readonly group = new Group();
  private readonly rows: number[];
  private readonly slices = makeSlices();
  private readonly clouds: Mesh<InstancedBufferGeometry, ShaderMaterial>[];

  constructor(
    private readonly scene: Scene,
    private readonly replica: Replica,
    private readonly motion: Motion,
  ) {
    this.rows = [...scene.models.keys()].filter((row) => scene.models[row].smoke);
    this.clouds = this.rows.map((row) => {
      const { size } = scene.models[row];
      const own = {
        toWorld: { value: new Matrix4() }, halfSize: { value: new Vector3(...size).multiplyScalar(0.5) }, color: { value: new Color() },
        opacity: { value: 1 }, seconds: { value: 0 }, bright: { value: kOnMap }, slices: { value: kSlices.onMap },
      };
      const uniforms = { ...UniformsUtils.clone(UniformsLib.fog), ...own };
      const look = { vertexShader: kVertex, fragmentShader: kFragment, uniforms, transparent: true, depthWrite: false, fog: true };
      const cloud = new Mesh(this.slices, new ShaderMaterial(look));
      cloud.frustumCulled = false;
      cloud.renderOrder = 5;
      return cloud;
    });
    if (this.clouds.length > 0) this.group.add(...this.clouds);
  }

  /** Null: map view. */
  set light(light: Light | null) {
    const bright = light ? light.ambient + 0.5 * sunOf(light) : kOnMap;
    const slices = light ? kSlices.within : kSlices.onMap;
    this.slices.instanceCount = slices;
    for (const { material } of this.clouds) Object.assign(material.uniforms, { bright: { value: bright }, slices: { value: slices } });
  }

  /** Updates transforms and the drift of the noise. */
  draw(): void {
    const { replica, motion, scene } = this;
    this.rows.forEach((row, k) => {
      const { size, origin } = scene.models[row];
      const { uniforms } = this.clouds[k].material;
      const matrix: Matrix4 = uniforms.toWorld.value;
      bodyMatrix(motion, row, origin ?? [0, 0, 0, 0], matrix).multiply(new Matrix4().makeTranslation(0, 0, size[2] / 2));
      uniforms.color.value.setHex(replica.color[row] >>> 8);
      uniforms.opacity.value = (replica.color[row] & 0xff) / 255;
      uniforms.seconds.value = replica.tick * scene.interval;
    });
  }

  dispose(): void {
    this.slices.dispose();
    for (const { material } of this.clouds) material.dispose();
  }
}

function makeSlices(): InstancedBufferGeometry {
  const plane = new PlaneGeometry(1, 1);
  const slices = new InstancedBufferGeometry();
  slices.index = plane.index;
  slices.setAttribute('position', plane.getAttribute('position'));
  slices.setAttribute('slice', new InstancedBufferAttribute(Float32Array.from({ length: kSlices.within }, (_, k) => k), 1));
  slices.instanceCount = kSlices.onMap;
  return slices;
}
