import { Device } from '../device.js';
import { planner } from '../generated/index.js';
import type { Path, PlannerState, Pose } from '../values.js';
import { contents, poseOf, wirePose } from './convert.js';

/**
 * A planner, which drives a robot to goals on a map. It goes on while any client has it open; wavefront cancels the goal
 * when the last one closes it.
 */
export class Planner extends Device {
  private goal: Pose | undefined;

  get state(): PlannerState {
    const { value, time } = this.stamped(planner.DATA_STATE);
    return {
      valid: value.valid !== 0,
      done: value.done !== 0,
      pose: poseOf(value.pos),
      goal: poseOf(value.goal),
      waypoint: poseOf(value.waypoint),
      index: value.waypointIdx,
      count: value.waypointsCount,
      time,
    };
  }

  /** Reads for ever: one PlannerState per new data message. Throws RequestTimeout after `timeout` s without. */
  updates(timeout?: number): AsyncGenerator<PlannerState, never, void> {
    return this.follow(() => this.state, timeout);
  }

  /** Whether the last data say that the goal of the last goTo() is reached; data of another goal do not count. */
  get arrived(): boolean {
    const data = this.latest(planner.DATA_STATE);
    return data !== undefined && data.done !== 0 && this.goal !== undefined && same(poseOf(data.goal), this.goal);
  }

  /** Plans a path to a pose on the map and drives there; after stop(), from resume() on. */
  async goTo({ x, y, a }: Pose): Promise<void> {
    this.insistOnFinite({ x, y, a });
    this.goal = { x, y, a };
    await this.command(planner.CMD_GOAL, { goal: wirePose(this.goal) });
  }

  /** Stops the robot until resume(); the planner keeps its goal. */
  async stop(): Promise<void> {
    await this.request(planner.REQ_ENABLE, { state: 0 });
  }

  /** Ends stop(). */
  async resume(): Promise<void> {
    await this.request(planner.REQ_ENABLE, { state: 1 });
  }

  /** The path as it was planned last; without waypoints if there is none. */
  async path(): Promise<Path> {
    const { waypoints, waypointsDistance } = await contents(this.request(planner.REQ_GET_WAYPOINTS));
    return { waypoints: waypoints.map(poseOf), length: waypointsDistance };
  }
}

/** Whether two poses are the same, whole turns aside, which drivers drop. */
function same(one: Pose, other: Pose): boolean {
  const turns = (one.a - other.a) / (2 * Math.PI);
  return one.x === other.x && one.y === other.y && Math.abs(turns - Math.round(turns)) * 2 * Math.PI < 1e-6;
}
