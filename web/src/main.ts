import { Driver } from './drive/driver';
import { OwnBody } from './drive/own_body';
import { Eyes } from './drive/eyes';
import { HeldKeys, handsOfAxes, sum, velocityOf, type Hands, type Velocity } from './drive/hands';
import { Link, type LinkState } from './link';
import { PicturePage } from './picture_page';
import { type Command, kNameLetters, kNamePattern, kNameRule, kWave } from './protocol/generated/commands';
import type { Replica } from './protocol/replica';
import { isOfAnother, wheelsOf, type Joined, type People, type PhysicsShapes, type Scene } from './protocol/scene';
import { Ask } from './ui/ask';
import { Chat } from './ui/chat';
import { Clock } from './ui/clock';
import { DevicePanel } from './ui/device_panel';
import { byId, download } from './ui/dom';
import { DriveBar } from './ui/drive_bar';
import { fillHelp, openHelp } from './ui/help';
import { listenForHeldKeys, listenForKeys } from './ui/keyboard';
import { PeopleMenu } from './ui/people_menu';
import { RobotList } from './ui/robot_list';
import { SpeedWish, fasterBy } from './ui/speed_wish';
import { Stick } from './ui/stick';
import { freeName } from './ui/texts';
import { Toolbar, worldTitle } from './ui/toolbar';
import { Pointer } from './view/pointer';
import type { Margins } from './view/camera_rig';
import { isPerson } from './view/people';
import { StageView } from './view/stage_view';
import { kDarkPage } from './view/theme';

const kLookPeriodMs = 150;
const kDrivePeriodMs = 50;
const kNearScale = 60; // pixels per metre from which a robot's sensors are discernible
const kSensorScale = 8; // pixels per metre below which sensor fans merge into fog
const kNameKey = 'playhouse.name';
const kNoticeMs = 4000;
const kWaveMs = 2500;
const kPauseMs = 250;
const kPhysicsMs = 1000; // minimum interval between requests of physics shapes
const kLinkTexts: Record<LinkState, string> = {
  connecting: 'connecting',
  live: 'connected',
  slow: 'This page is too slow: it draws what the program sends only seconds later.',
  silent: 'The program is silent. It may be busy or stopped in a debugger.',
  lost: 'Connection lost. Trying again … What you see is old.',
};

/** WebSocket address of the server; the fragment of the page's address is the access token. */
function liveAddress(page: Location): string {
  const live = new URL('live', page.href.replace(/^http/, 'ws'));
  live.hash = '';
  const token = page.hash.slice(1);
  if (token !== '') live.search = `token=${encodeURIComponent(token)}`;
  return live.href;
}

/** The page: owns all parts and connects them. */
class Page {
  private scene: Scene | null = null;
  private replica: Replica | null = null;
  private looked = '';
  private lookTime = 0;
  private noticeTimer = 0;
  private readonly speedWish = new SpeedWish();
  private readonly driver = new Driver();
  private readonly heldKeys = new HeldKeys();
  private hurry = false;
  private wheels: number | null = null; // of the selected robot
  private live = false;
  private own: OwnBody | null = null;
  private physicsAsked = false; // request pending
  private physicsOld = false; // population changed since the last request
  private flown = 0; // ms, time of the last frame in free flight
  private rights: People = { people: [], you: 0, drives: true, joins: true, manages: true, edits: true };
  private sayings = 0; // number of utterances of the own body
  private enters = false; // joined, but not in the scene yet
  private awaited = 0; // models requested but not spawned yet
  private readonly pointer: Pointer;

  private readonly view = new StageView(byId<HTMLCanvasElement>('picture'), byId<HTMLCanvasElement>('overlay'), margins);
  private readonly link = new Link(liveAddress(location), {
    scene: (scene, replica) => this.showScene(scene, replica),
    population: (scene, replica) => this.showPopulation(scene, replica),
    packet: () => this.showPacket(),
    history: (history) => this.clock.follow(history),
    said: (lines) => this.chat.recall(lines, this.scene!.interval),
    file: (world) => download(world.file, new Blob([world.text], { type: 'text/plain' })),
    people: (people) => this.showPeople(people),
    joined: (joined) => this.joined(joined),
    driven: ({ input, tick }) => this.own?.counts(input, tick),
    physics: (shapes) => this.showPhysics(shapes),
    notice: (text) => {
      this.awaited = 0; // the notice may be the reason of a refused spawn
      this.physicsAsked = false; // or of refused shapes
      this.showNotice(text);
    },
    state: (state, why) => this.showLink(state, why),
  });
  private readonly people = new PeopleMenu({
    mute: (viewer, on) => this.manage({ do: 'mute', viewer, on }),
    kick: (viewer) => this.manage({ do: 'kick', viewer }),
    nameOf: (model) => this.scene?.models[this.replica?.rows.get(model) ?? -1]?.name,
  });
  private readonly toolbar = new Toolbar(byId('bar'), this.view.layers, this.people, {
    togglePause: () => this.manage({ do: this.replica?.paused ? 'resume' : 'pause' }),
    step: () => this.manage({ do: 'step' }),
    speed: (times) => this.askSpeed(times),
    layers: () => {
      this.view.applyLayers();
      this.askPhysics();
    },
    tilt: () => this.tilt(),
    fit: () => this.fit(),
    toggleList: () => byId('robots').classList.toggle('desk'),
    add: (robot) => this.add(robot),
    join: () => this.join(),
    wave: () => this.wave(),
    fly: () => this.toggleFlight(),
    save: () => this.edit({ do: 'save' }),
    picture: () => void this.savePicture(),
    help: () => openHelp(this.help),
  });
  private readonly clock = new Clock(byId('clock'), {
    rewind: (tick) => this.manage({ do: 'rewind', tick }),
    pause: () => this.manage({ do: 'pause' }),
    goOn: () => this.manage({ do: 'resume' }),
  });
  private readonly robots = new RobotList(byId('robots'), (row) => {
    this.select(row);
    this.goTo(row);
  });
  private readonly panel = new DevicePanel(byId('panel'), {
    close: () => this.select(null),
    follow: (row) => this.follow(this.view.followed === row ? null : row),
    copy: () => this.copy(),
    remove: () => this.remove(),
  });
  private readonly help = byId<HTMLDialogElement>('help');
  private readonly ask = new Ask(byId<HTMLDialogElement>('ask'));
  private readonly chat = new Chat(byId('chat'), (text) => this.say(text));
  private readonly driveBar = new DriveBar(byId('drive'));
  private readonly stick = new Stick(byId('stick'), () => this.drive());

  constructor() {
    fillHelp(this.help);
    byId('robots').classList.add('desk');
    this.view.lead = (now) => this.leadOwn(now);
    this.pointer = new Pointer(byId('picture'), this.view, {
      select: (row) => this.select(row),
      carry: (row, x, y, a) => this.edit({ do: 'drag', model: this.idOf(row), x, y, a }),
      flies: (speed) => this.showNotice(`flies at ${speed.toPrecision(2)} m/s`),
      looked: () => this.panel.showFollowed(this.view.followed),
      describe: (what) => this.showNotice(what),
      mayCarry: (row) => (this.live && this.rights.edits && this.scene?.models[row].movable) ?? false,
    });
    listenForKeys(this.keys());
    listenForHeldKeys(this.heldKeys, (fast) => {
      this.hurry = fast;
      this.drive();
    });
    this.listenForLooks(byId('picture'));
    window.setInterval(() => this.drive(), kDrivePeriodMs);
    new ResizeObserver(() => showBarHeight()).observe(byId('bar'));
    kDarkPage.addEventListener('change', () => this.view.setTheme());
    this.showLink('connecting');
    requestAnimationFrame((now) => this.frame(now));
  }

  /** State for tests and for inspection in the console. */
  inspect() {
    const { scene, replica, view } = this;
    const rowOf = (name: string) => scene?.models.findIndex((model) => model.name === name) ?? -1;
    return {
      tick: replica?.tick ?? -1,
      paused: replica?.paused ?? false,
      speed: replica?.speed ?? 1,
      gliding: view.rig.gliding,
      scans: replica?.scans.size ?? 0,
      waving: [...(replica?.says ?? [])].filter(([, text]) => text === kWave).map(([row]) => scene?.models[row].name),
      eye: view.rig.eye,
      flies: view.flight !== null,
      physics: view.layers.physics ? view.physics.count : 0,
      driven: this.driver.driven,
      hovered: view.hovered === null ? null : (scene?.models[view.hovered].name ?? null),
      labels: [...view.labelled].map((row) => scene?.models[row].name),
      meshes: view.meshes,
      bubbles: [...view.spoken].map(([row, text]) => [scene?.models[row].name, text]),
      drawings: [...(replica?.drawings ?? [])].map(([row, runs]) => [scene?.models[row].name, runs.length]),
      tokens: [...view.tokens].map(([row, count]) => [scene?.models[row].name, count]),
      robots: scene?.models.filter((model) => model.kind === 'position').map((model) => model.name) ?? [],
      drawn: (name: string) => {
        const row = rowOf(name);
        return row < 0 || !view.motion ? null : { x: view.motion.x[row], y: view.motion.y[row], a: view.motion.a[row] };
      },
      pose: (name: string) => {
        const row = rowOf(name);
        return row < 0 || !replica ? null : { x: replica.x[row] / 1000, y: replica.y[row] / 1000 };
      },
      pixel: (name: string) => {
        const row = rowOf(name);
        return row < 0 || !view.motion ? null : view.rig.pixelOf(view.motion.x[row], view.motion.y[row], 0.1);
      },
      pixelAt: (x: number, y: number) => view.rig.pixelOf(x, y, 0),
    };
  }

  /** Downloads the drawn world as `cave.42.5s.png`: the world's name and the simulated time. */
  private async savePicture(): Promise<void> {
    const { scene, replica } = this;
    if (!scene || !replica) return;
    const seconds = (replica.tick * scene.interval).toFixed(1);
    download(`${worldTitle(scene.name)}.${seconds}s.png`, await this.view.picturePng());
  }

  private frame(now: number): void {
    this.flyOn(now);
    this.view.frame(now);
    this.pointer.update(now);
    this.link.acknowledge();
    this.tellView(now);
    requestAnimationFrame((next) => this.frame(next));
  }

  private showScene(scene: Scene, replica: Replica): void {
    const selected = this.view.selected === null ? undefined : this.scene?.models[this.view.selected].id;
    this.view.selected = this.view.followed = this.view.hovered = null;
    this.scene = scene;
    this.replica = replica;
    this.looked = '';
    this.awaited = 0;
    this.physicsAsked = false;
    if (!this.view.flight) this.leaveEyes();
    this.chat.clear();
    this.view.physics.clear();
    this.clock.follow({ ticks: [] });
    this.view.show(scene, replica);
    this.toolbar.showWorld(scene.name);
    this.toolbar.showTilted(this.view.rig.pitch > 0.02);
    this.toolbar.showAddable(scene.addable);
    this.own = null;
    this.enters = false;
    this.showJoin();
    this.askPhysics();
    this.robots.show(scene, replica);
    this.select((selected === undefined ? undefined : replica.rows.get(selected)) ?? null);
  }

  /** The population has changed. */
  private showPopulation(scene: Scene, replica: Replica): void {
    const before = this.replica!;
    const now = (row: number) => replica.rows.get(before.scene.models[row].id) ?? null;
    const selected = this.view.selected;
    this.scene = scene;
    this.replica = replica;
    this.view.follow(scene, replica);
    this.pointer.follow(now);
    this.robots.show(scene, replica);
    if (this.enters) this.embody();
    else if (this.own !== null && !replica.rows.has(this.own.id)) this.own = null;
    this.showJoin();
    this.showWheels();
    this.physicsOld = true;
    this.askPhysics();
    const came = replica.rows.get(scene.models.filter(({ id, parent }) => parent < 0 && !before.rows.has(id)).at(-1)?.id ?? -1);
    if (this.awaited > 0 && came !== undefined) {
      --this.awaited;
      this.select(came);
    } else if (selected !== null && this.view.selected === null) {
      this.select(null);
    } else if (this.view.selected !== null) {
      this.robots.showSelected(this.view.selected);
      this.panel.show(scene, replica, this.view.roots, this.view.selected);
    }
  }

  private idOf(row: number): number {
    return this.scene!.models[row].id;
  }

  private showPacket(): void {
    const { scene, replica } = this;
    if (!scene || !replica) return;
    this.own?.correct(replica, performance.now());
    this.view.changed(performance.now());
    this.toolbar.showPaused(replica.paused);
    this.toolbar.showSpeed(this.speedWish.over(replica.speed, performance.now()));
    this.clock.show(replica, scene.interval);
    this.chat.listen(replica, scene.interval);
    this.robots.update();
    this.panel.update();
  }

  private showLink(state: LinkState, why = ''): void {
    this.live = state === 'live' || state === 'slow';
    document.body.dataset.link = state;
    if (!this.live) this.letGo();
    if (state === 'lost') this.driver.forget();
    this.toolbar.showLink(state, kLinkTexts[state], this.live);
    this.clock.showLink(this.live);
    const banner = byId('lost');
    banner.hidden = state === 'live' || state === 'connecting';
    banner.textContent = why === '' ? kLinkTexts[state] : `The program says: ${why}.`;
  }

  private showPeople(people: People): void {
    this.rights = people;
    this.people.show(people);
    this.toolbar.showRights(people);
    document.body.classList.toggle('guest', !people.edits);
    this.showJoin();
    this.showWheels();
  }

  /** Sends a command that needs admin rights; without them shows a notice instead. */
  private manage(command: Command): void {
    if (this.mayManage()) this.link.send(command);
  }

  /** The same for commands that change the population, which recordings do not allow. */
  private edit(command: Command): void {
    if (this.mayEdit()) this.link.send(command);
  }

  private mayEdit(): boolean {
    if (!this.mayManage()) return false;
    if (!this.rights.edits) this.showNotice('This is a recording: nothing in it can be changed.');
    return this.rights.edits;
  }

  private mayManage(): boolean {
    if (!this.rights.manages) this.showNotice('Only an admin may do that in this world.');
    return this.rights.manages;
  }

  private showNotice(text: string): void {
    const notice = byId('notice');
    notice.textContent = text;
    notice.hidden = false;
    window.clearTimeout(this.noticeTimer);
    this.noticeTimer = window.setTimeout(() => (notice.hidden = true), kNoticeMs);
  }

  /** Row of the own body; null: not joined, or not in the scene yet. */
  private get ownRow(): number | null {
    return this.own === null ? null : (this.replica?.rows.get(this.own.id) ?? null);
  }

  /**
   * Chooses the base that the controls drive: that of the selected robot or own body, if this viewer may;
   * with nothing selected, the own body while its eyes are looked through.
   */
  private showWheels(): void {
    const { scene, ownRow, view: { selected, seenBy } } = this;
    const row = selected ?? (seenBy?.row === ownRow ? ownRow : null);
    const may = this.rights.drives || (row !== null && row === ownRow);
    const wheels = row === null || !scene || !may ? null : wheelsOf(scene, this.view.roots, row);
    this.wheels = wheels === null || isOfAnother(this.rights, scene!.models[wheels].id) ? null : wheels;
    this.driveBar.show(this.wheels === null ? null : scene!.models[this.wheels]);
    this.stick.show(this.wheels !== null);
  }

  private select(row: number | null): void {
    if (row !== this.view.selected) this.letGo();
    this.view.selected = row;
    this.showWheels();
    if (row === null) this.follow(null);
    this.robots.showSelected(row);
    this.link.send({ do: 'select', model: row === null ? null : this.idOf(row) });
    if (row === null || !this.scene || !this.replica) this.panel.hide();
    else this.panel.show(this.scene, this.replica, this.view.roots, row);
    this.panel.showFollowed(this.view.followed);
    if (row !== null) this.view.reveal(row);
    this.view.redraw();
  }

  /** Combined command of keys, gamepads and touch stick. */
  private hands(): Hands {
    const pads = document.hasFocus() ? (navigator.getGamepads?.() ?? []).filter((pad) => pad?.connected) : []; // some browsers want https for them
    return sum([this.heldKeys.hands(this.hurry), this.stick.hands(), ...pads.map((pad) => handsOfAxes(pad!.axes))]);
  }

  /** Sends the command to the server. */
  private drive(): void {
    const hands = this.hands();
    const velocity = this.walking(hands) ?? velocityOf(hands);
    const wheels = this.live && !this.view.flight && this.wheels !== null ? this.idOf(this.wheels) : null;
    const now = performance.now();
    for (const order of this.driver.next(wheels, velocity, now)) this.link.send({ do: 'drive', ...(this.own?.number(order, now) ?? order) });
    this.driveBar.showVelocity(velocity);
  }

  /** Command for a person in first-person view; null: not in the view of a person. */
  private walking(hands: Hands): Velocity | null {
    const { seenBy, motion } = this.view;
    if (!seenBy || !motion || !this.scene) return null;
    const { row, eyes } = seenBy;
    const walks = isPerson(this.scene, row);
    if (!walks || hands.sideways !== 0) eyes.follow(motion.a[row]);
    this.view.redraw();
    return walks ? eyes.walk(hands, motion.a[row]) : null;
  }

  /** A click on the view captures the mouse for looking around, until Esc. */
  private listenForLooks(picture: HTMLElement): void {
    picture.addEventListener('click', (event) => {
      const touch = event instanceof PointerEvent && event.pointerType === 'touch'; // dragging looks around
      if (!touch && (this.view.seenBy || this.view.flight)) void picture.requestPointerLock();
    });
    document.addEventListener('pointermove', (event) => {
      const looks = this.view.flight ?? this.view.seenBy?.eyes;
      if (document.pointerLockElement !== picture || !looks) return;
      looks.look(event.movementX, event.movementY);
      this.view.redraw();
    });
    document.addEventListener('pointerlockchange', () => {
      if (document.pointerLockElement === null) this.drive();
    });
  }

  /** Toggles the first-person view of the selected robot or person. */
  private toggleEyes(): void {
    const { selected: row, motion } = this.view;
    if (this.view.seenBy || row === null || !motion) return this.leaveEyes();
    const seer = cameraOf(this.scene!, this.view.roots, row) ?? row;
    this.view.seeThrough({ row: seer, eyes: new Eyes(motion.a[seer]) });
    this.toolbar.showFlies(false);
    this.showWheels();
  }

  private leaveEyes(): void {
    if (document.pointerLockElement) document.exitPointerLock();
    this.view.seeThrough(null);
    this.toolbar.showFlies(false);
    this.showWheels();
  }

  /** Toggles free flight of the camera. */
  private toggleFlight(): void {
    if (this.view.flight) return this.leaveEyes();
    this.letGo();
    this.follow(null);
    this.view.fly();
    this.toolbar.showFlies(true);
    this.flown = performance.now();
  }

  private flyOn(now: number): void {
    const { flight } = this.view;
    const seconds = Math.min(Math.max(now - this.flown, 0) / 1000, 0.1);
    this.flown = now;
    if (flight?.move(this.hands(), seconds)) this.view.redraw();
  }

  private showJoin(): void {
    const { scene, own } = this;
    this.chat.showSpeaks(own !== null);
    this.toolbar.showJoin(own !== null || (this.rights.joins && (scene?.models.some((_, row) => isPerson(scene, row)) ?? false)), own !== null);
  }

  /** Joins as a person at the centre of the view; or leaves. */
  private join(): void {
    if (this.own !== null) {
      this.link.send({ do: 'remove', model: this.own.id });
      return this.leaveEyes();
    }
    const at = this.middle();
    if (!at) return;
    const come = (name: string) => this.link.send({ do: 'join', name, x: at.x, y: at.y, a: 0 });
    const given = this.rights.people.find(({ viewer }) => viewer === this.rights.you)?.name;
    if (given !== undefined) return come(given);
    const taken = new Set(this.scene?.models.map(({ name }) => name));
    const free = freeName(localStorage.getItem(kNameKey) ?? 'visitor', taken, kNameLetters);
    this.ask.open('Your name in this world', { value: free, pattern: kNamePattern, rule: kNameRule, most: kNameLetters }, (name) => {
      if (name !== free) localStorage.setItem(kNameKey, name);
      come(name);
    });
  }

  /** The viewer's body was spawned. */
  private joined(joined: Joined): void {
    if (!this.scene) return;
    this.own = new OwnBody(joined, this.scene.interval);
    this.enters = true;
    this.showJoin();
    this.embody();
  }

  /** Enters the body once both it and its row are known, in whichever order they arrive. */
  private embody(): void {
    const row = this.ownRow;
    if (row === null || !this.enters) return;
    this.enters = false;
    this.askPhysics();
    this.leaveEyes();
    this.select(row);
    this.toggleEyes();
  }

  /** Predicted pose of the own body. */
  private leadOwn(now: number): { row: number; x: number; y: number; a: number } | null {
    const row = this.ownRow;
    const place = row === null || !this.live ? null : this.own!.at(now);
    return place && { row: row!, ...place };
  }

  /** Requests the physics shapes if they are needed. */
  private askPhysics(): void {
    if (!this.live || this.physicsAsked || (this.own === null && !this.view.layers.physics)) return;
    this.physicsAsked = true;
    this.physicsOld = false;
    this.link.send({ do: 'physics' });
  }

  private showPhysics(shapes: PhysicsShapes): void {
    this.physicsAsked = false;
    this.own?.meet(shapes);
    this.view.showPhysics(shapes);
    if (this.physicsOld) window.setTimeout(() => this.askPhysics(), kPhysicsMs);
  }

  private say(text: string): void {
    const { own, replica } = this;
    if (own === null) return;
    ++this.sayings;
    const row = replica?.rows.get(own.id);
    const again = text !== '' && row !== undefined && replica!.says.get(row) === text;
    if (!again) return this.link.send({ do: 'say', text });
    // Viewers see only changes: repeated text is cleared first and said again after a pause.
    this.link.send({ do: 'say', text: '' });
    window.setTimeout(() => this.link.send({ do: 'say', text }), kPauseMs);
  }

  /** Waves for a moment; replaces the text said before. */
  private wave(): void {
    const { own } = this;
    if (own === null) return;
    this.say(kWave);
    const { sayings } = this;
    window.setTimeout(() => {
      if (this.own === own && this.sayings === sayings) this.say(''); // unless text was said meanwhile
    }, kWaveMs);
  }

  private letGo(): void {
    this.heldKeys.clear();
    this.stick.release();
  }

  /** The floor point at the centre of the view. */
  private middle(): { x: number; y: number } | null {
    const { left, right, top, bottom } = margins();
    const { rig } = this.view;
    return rig.floorAt((left + rig.width - right) / 2, (top + rig.height - bottom) / 2);
  }

  /** Spawns a robot of this type at the centre of the view. */
  private add(robot: number): void {
    const at = this.middle();
    if (!this.live || !at || !this.mayEdit()) return;
    ++this.awaited;
    this.edit({ do: 'add', robot, x: at.x, y: at.y, a: 0 });
  }

  /** Spawns a copy of the selected robot beside it. */
  private copy(): void {
    const { selected: row, motion } = this.view;
    if (row === null || !motion || !this.live || !this.mayEdit()) return;
    const { size } = this.scene!.models[row];
    const beside = 1.5 * Math.max(size[0], size[1], 0.1);
    const a = motion.a[row];
    ++this.awaited;
    this.edit({ do: 'copy', model: this.idOf(row), x: motion.x[row] + Math.sin(a) * beside, y: motion.y[row] - Math.cos(a) * beside, a });
  }

  private remove(): void {
    const { selected: row } = this.view;
    if (row !== null && this.live) this.edit({ do: 'remove', model: this.idOf(row) });
  }

  private follow(row: number | null): void {
    this.view.followed = row;
    if (row !== null) this.goTo(row);
    this.panel.showFollowed(row);
  }

  private goTo(row: number): void {
    this.view.goTo(row, kNearScale);
  }

  private tilt(): void {
    this.toolbar.showTilted(this.view.rig.pitch <= 0.02);
    this.view.tilt();
  }

  private fit(): void {
    this.follow(null);
    this.view.fitAll();
  }

  private faster(steps: number): void {
    if (this.replica) this.askSpeed(fasterBy(steps, this.speedWish.over(this.replica.speed, performance.now())));
  }

  private askSpeed(speed: number): void {
    if (!this.live || !this.mayManage()) return;
    this.speedWish.ask(speed, performance.now());
    this.toolbar.showSpeed(speed);
    this.manage({ do: 'speed', times_real_time: speed });
  }

  private keys(): Record<string, () => void> {
    return {
      ' ': () => this.manage({ do: this.replica?.paused ? 'resume' : 'pause' }),
      '.': () => this.manage({ do: 'step' }),
      '<': () => this.faster(-1),
      '>': () => this.faster(1),
      t: () => this.tilt(),
      f: () => this.fit(),
      l: () => this.follow(this.view.followed === null ? this.view.selected : null),
      v: () => this.toolbar.toggle('sensors'),
      m: () => this.toolbar.toggle('fiducials'),
      r: () => this.toolbar.toggle('trails'),
      n: () => this.toolbar.toggle('names'),
      b: () => this.toolbar.toggle('speech'),
      g: () => this.toolbar.toggle('grid'),
      j: () => this.toolbar.toggle('drawings'),
      i: () => this.toggleEyes(),
      x: () => this.toolbar.toggle('physics'),
      o: () => this.toggleFlight(),
      h: () => this.wave(),
      k: () => this.chat.toggle(),
      Enter: () => this.chat.focus(),
      p: () => void this.savePicture(),
      '/': () => this.robots.focus(),
      '?': () => openHelp(this.help),
      c: () => this.copy(),
      Delete: () => this.remove(),
      Escape: () => (this.view.seenBy || this.view.flight ? this.leaveEyes() : this.select(null)),
    };
  }

  /** Sends the visible area to the server when it has changed (interest management): it sends sensor data of robots there. */
  private tellView(now: number): void {
    if (!this.replica || now - this.lookTime < kLookPeriodMs) return;
    this.lookTime = now;
    const { rig, layers } = this.view;
    const box = rig.view();
    const round = (value: number) => Math.min(Math.max(Math.round(value * 10) / 10, -1e6), 1e6);
    const look = {
      do: 'look' as const,
      x_min: round(box.x_min),
      y_min: round(box.y_min),
      x_max: round(box.x_max),
      y_max: round(box.y_max),
      sensors: (layers.sensors || layers.fiducials) && (rig.eye !== null || rig.scale >= kSensorScale),
    };
    const text = JSON.stringify(look);
    if (text === this.looked) return;
    this.looked = text;
    this.link.send(look);
  }
}

/** Row of the camera of a top-level model; null if it has none. */
function cameraOf(scene: Scene, roots: Int32Array, row: number): number | null {
  const camera = scene.models.findIndex((model, part) => roots[part] === row && model.kind === 'camera');
  return camera < 0 ? null : camera;
}

/** Publishes the height of the toolbar, which wraps in narrow windows, as a CSS variable. */
function showBarHeight(): void {
  document.documentElement.style.setProperty('--bar', `${byId('bar').offsetHeight}px`);
}

/** Widths covered by panels at the sides of the view. */
function margins(): Margins {
  const wide = window.innerWidth > 720;
  const panel = byId('panel');
  const list = byId('robots').getBoundingClientRect();
  const gap = 24;
  return {
    left: gap + list.right,
    right: gap + (wide && !panel.hidden ? window.innerWidth - panel.getBoundingClientRect().left : 0),
    top: gap + byId('bar').getBoundingClientRect().bottom + (wide ? 0 : 46), // the clock, on phones
    bottom: gap + (wide ? 56 : list.width > 0 ? coveredBelow('stick', 'panel') : coveredBelow('panel')),
  };
}

/**
 * Height from the lower edge to the top of the highest of these that is shown:
 * the stick takes the place below an open list.
 */
function coveredBelow(...ids: string[]): number {
  const shown = ids.map(byId).filter(({ offsetHeight }) => offsetHeight > 0);
  const tops = shown.map((each) => each.getBoundingClientRect().top);
  return window.innerHeight - Math.min(window.innerHeight, ...tops);
}

/** Replaces the page by an error if the browser lacks WebGL 2. */
function sayWhyNot(): void {
  for (const id of ['bar', 'robots', 'clock']) byId(id).hidden = true;
  const banner = byId('lost');
  banner.textContent = 'This browser has no WebGL 2, so it cannot draw the world. Switch its graphics acceleration on, or take another browser.';
  banner.hidden = false;
}

const draws = document.createElement('canvas').getContext('webgl2') !== null;
if (new URLSearchParams(location.search).has('picture')) {
  Object.defineProperty(window, 'playhousePicture', { value: draws ? new PicturePage() : null });
} else if (draws) {
  const page = new Page();
  Object.defineProperty(window, 'playhouse', { get: () => page.inspect() });
} else {
  sayWhyNot();
}
