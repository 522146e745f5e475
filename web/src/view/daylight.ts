import {
  BackSide, CanvasTexture, Color, DirectionalLight, FogExp2, Group, HemisphereLight, Mesh, PMREMGenerator, RepeatWrapping, Scene as Picture, ShaderChunk,
  ShaderMaterial, SphereGeometry, SRGBColorSpace, Vector3, type Camera, type WebGLRenderer, type WebGLRenderTarget,
} from 'three';
import type { Light } from '../protocol/scene';
import { sunOf, type Shine } from './surfaces';

const kReach = 14; // m, half extent of the shadow map's frustum
const kAhead = 10; // m, offset of the frustum's centre ahead of the eye
const kHigh = 40; // m, height of the frustum: higher bodies cast no shadow
const kTexels = 2048; // of the shadow map
const kDome = 400; // m, radius of the sky dome; less than the far plane
const kContrast = 0.05; // contrast at the visibility (Koschmieder)

// Fog by Beer's law over distance; that of three.js is exponential in the squared depth.
const kFogChunks = ['fog_pars_vertex', 'fog_vertex', 'fog_pars_fragment', 'fog_fragment'] as const;
for (const name of kFogChunks) {
  ShaderChunk[name] = ShaderChunk[name]
    .replace('varying float vFogDepth', 'varying vec3 vFogAt')
    .replace('vFogDepth = - mvPosition.z', 'vFogAt = mvPosition.xyz')
    .replace('fogDensity * fogDensity * vFogDepth * vFogDepth', 'fogDensity * length( vFogAt )')
    .replace('vFogDepth', 'length( vFogAt )');
}

const kDirection = `
  varying vec3 way;
  void main() {
    way = position;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;

/** Sky shader: paler near the horizon, sun disc, and fog towards the horizon. */
const kSky = `
  uniform vec3 sky, fog, toSun;
  uniform float sun, fogged;
  varying vec3 way;
  void main() {
    vec3 d = normalize(way);
    float high = max(d.z, 0.0);
    vec3 light = mix(sky, sky * vec3(0.55, 0.68, 0.86), smoothstep(0.0, 0.7, high));
    light += sun * vec3(1.0, 0.95, 0.8) * smoothstep(0.99, 0.9995, dot(d, toSun));
    gl_FragColor = vec4(mix(light, fog, fogged * exp(-5.0 * high)), 1.0);
    #include <colorspace_fragment>
  }`;

/** Ambient environment: sky colour from above, floor colour from below. */
const kAround = `
  uniform vec3 above, below;
  varying vec3 way;
  void main() {
    gl_FragColor = vec4(mix(below, above, 0.5 + 0.5 * normalize(way).z), 1.0);
  }`;

/**
 * Daylight of a scene, as in camera images (playhouse/render/shaders.cc): sun with
 * shadows, sky, environment reflections and fog. Active from show() to hide().
 */
export class Daylight {
  readonly group = new Group();
  /** Floor texture of 1 m slabs. */
  readonly slabs = slabs();
  private readonly sun = new DirectionalLight();
  private readonly everywhere = new HemisphereLight();
  private readonly dome: Mesh<SphereGeometry, ShaderMaterial>;
  private shine: Shine | null = null;
  private mirrored: WebGLRenderTarget | null = null; // environment map

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly picture: Picture,
  ) {
    const vector = () => ({ value: new Vector3() });
    const uniforms = { sky: { value: new Color() }, fog: { value: new Color() }, toSun: vector(), sun: { value: 0 }, fogged: { value: 0 } };
    const look = { vertexShader: kDirection, fragmentShader: kSky, uniforms, side: BackSide, depthTest: false, depthWrite: false };
    this.dome = new Mesh(new SphereGeometry(kDome, 48, 24), new ShaderMaterial(look));
    this.dome.renderOrder = -100;
    this.dome.frustumCulled = false;
    const { shadow } = this.sun;
    shadow.mapSize.set(kTexels, kTexels);
    shadow.normalBias = 0.03;
    Object.assign(shadow.camera, { left: -kReach, right: kReach, top: kReach, bottom: -kReach, near: 1, far: 2 * kHigh });
    shadow.camera.updateProjectionMatrix();
    renderer.shadowMap.enabled = true;
    this.everywhere.intensity = Math.PI;
    this.group.add(this.dome, this.everywhere, this.sun, this.sun.target);
    this.group.visible = false;
  }

  show(light: Light): Shine {
    if (light === this.shine?.light) return this.shine;
    this.hide();
    const sun = sunOf(light);
    const [sky, fog] = [light.sky, light.fog].map((color) => new Color().setRGB(...color, SRGBColorSpace).multiplyScalar(light.day));
    const { uniforms } = this.dome.material;
    uniforms.sky.value = sky;
    uniforms.fog.value = fog;
    uniforms.toSun.value = new Vector3(...light.to_sun);
    uniforms.sun.value = sun > 0 ? 1 : 0;
    uniforms.fogged.value = light.visibility > 0 ? 1 : 0;
    this.sun.intensity = Math.PI * sun; // Lambertian: radiance = irradiance / pi
    this.sun.castShadow = sun > 0;
    const most = Math.max(sky.r, sky.g, sky.b, 0.01);
    const above = new Color(1, 1, 1).lerp(sky.clone().multiplyScalar(1 / most), 0.5).multiplyScalar(light.ambient);
    const below = new Color(light.floor).multiplyScalar(0.6 * light.ambient);
    this.everywhere.color = above;
    this.everywhere.groundColor = below;
    this.picture.fog = light.visibility > 0 ? new FogExp2(fog, -Math.log(kContrast) / light.visibility) : null;
    this.group.visible = true;
    this.mirrored = this.around(above, below);
    this.shine = { light, around: this.mirrored.texture };
    return this.shine;
  }

  hide(): void {
    this.mirrored?.dispose();
    this.picture.fog = this.shine = this.mirrored = null;
    this.group.visible = false;
  }

  /** Centres sky dome and shadow frustum on the camera. */
  follow(camera: Camera): void {
    const { shine, sun } = this;
    if (!shine) return;
    this.dome.position.copy(camera.position);
    const ahead = camera.getWorldDirection(new Vector3()).setZ(0);
    if (ahead.lengthSq() > 0) ahead.setLength(kAhead);
    // Snapped to shadow map texels, so that shadow edges do not shimmer.
    const step = (2 * kReach) / kTexels;
    const middle = camera.position.clone().setZ(0).add(ahead).divideScalar(step).round().multiplyScalar(step);
    sun.target.position.copy(middle);
    sun.position.copy(middle).addScaledVector(new Vector3(...shine.light.to_sun), kHigh);
  }

  private around(above: Color, below: Color): WebGLRenderTarget {
    const material = new ShaderMaterial({
      vertexShader: kDirection, fragmentShader: kAround, uniforms: { above: { value: above }, below: { value: below } }, side: BackSide,
    });
    const sphere = new Mesh(new SphereGeometry(10, 32, 16), material);
    const inside = new Picture();
    inside.add(sphere);
    const maker = new PMREMGenerator(this.renderer);
    const target = maker.fromScene(inside, 0, 0.1, 100);
    maker.dispose();
    material.dispose();
    sphere.geometry.dispose();
    return target;
  }
}

/** Tiling texture of a 1 m slab with joints. */
function slabs(): CanvasTexture {
  const size = 256; // pixels
  const canvas = Object.assign(document.createElement('canvas'), { width: size, height: size });
  const context = canvas.getContext('2d')!;
  context.fillStyle = '#d2d2d2';
  context.fillRect(0, 0, size, size);
  context.fillStyle = '#ffffff';
  context.fillRect(2, 2, size - 4, size - 4);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.anisotropy = 8;
  return texture;
}
