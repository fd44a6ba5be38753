/** A structure in the engine: its model with numbers computed by the package, its state and its readings. */

import { readArrays } from "./arrays.js";

// fields of the newer engine that the older one lacks, equal in every model that is not refused
const UNKNOWN = new Set(["jnt_springyield", "tendon_springyield", "flex_yield", "tendon_type", "efmC_perm", "flex_vertcell"]);
// integer fields that count features which the older one lacks
const COUNTED = /_plasticadr$|_plasticmode$/;

/** Build the engine's model from the page's data; throws an error with the reason if that is impossible. */
export async function buildModel(engine, live) {
  const take = await readArrays(live.arrays);
  let model;
  try {
    model = engine.from_xml_string(live.source);
  } catch (error) {
    throw new Error(`the engine in this page cannot read the model: ${error.message ?? "its version is newer"}`);
  }
  for (const [name, mine] of Object.entries(live.layout)) {
    const theirs = field(model, name);
    if (theirs === undefined && (UNKNOWN.has(name) || COUNTED.test(name))) continue;
    const same = theirs?.length === mine.length && mine.every((value, place) => Number(theirs[place]) === value);
    if (!same) throw new Error(`the engine in this page has another layout of the model (${name})`);
  }
  for (const [name, where] of Object.entries(live.numbers)) {
    const values = take(where);
    const theirs = field(model, name);
    if (theirs === undefined && UNKNOWN.has(name)) continue;
    if (!put(theirs, values, live.layout.eq_type?.length)) throw new Error(`the engine in this page has no numbers of this kind (${name})`);
  }
  for (const [name, values] of Object.entries(live.options)) setOption(model, name, values);
  return { model, start: Float64Array.from(take(live.start)) };
}

function field(model, name) {
  try {
    return model[name] ?? undefined;
  } catch {
    return undefined;
  }
}

/** Write numbers; returns whether the sizes match. Rows of equalities are longer in some versions, padded with zeros. */
function put(places, values, equalities) {
  if (places?.length === values.length) {
    places.set(values);
    return true;
  }
  const [wide, own] = [values?.length, places?.length].map((length) => length / equalities);
  if (!Number.isInteger(own) || !(own < wide)) return false;
  for (const [at, value] of values.entries()) {
    const [row, column] = [Math.floor(at / wide), at % wide];
    if (column < own) places[row * own + column] = value;
    else if (value !== 0) return false;
  }
  return true;
}

function setOption(model, name, values) {
  if (values.length === 1) model.opt[name] = values[0];
  else model.opt[name].set(values);
}

/** A structure that moves: state and readings in the model's units, lengths of drawn parts in m. */
export function makeWing(engine, live, { model, start }) {
  const data = new engine.MjData(model);
  const { hinges, anchors, units, tendons, controls, brakes, motors } = live;
  const strengths = live.protocol.drives.map((drive) => drive.strength);
  const values = new Map(live.knobs.map((knob) => [knob.key, knob.value]));
  // views of the engine's memory, which move when the memory grows
  let views = null;
  // Runge-Kutta steps leave the lengths of their end, Euler steps those of their start
  const { explicit } = live.protocol;
  const from = new Float64Array(explicit ? data.qpos.length : 0);
  const measured = new Float64Array(explicit ? live.distances.length : 0);
  const braked = new Float64Array(live.brakeWays.length);
  let stepped = false;
  let widest = 0;

  function view() {
    if (views === null || views.qpos.length === 0) {
      const names = ["qpos", "qvel", "ctrl", "ten_length", "xpos", "xmat", "site_xpos", "act", "xfrc_applied", "xipos", "actuator_force"];
      views = Object.fromEntries(names.map((name) => [name, data[name]]));
    }
    return views;
  }

  function reset() {
    engine.mj_resetData(model, data);
    view().qpos.set(start);
    widest = 0;
  }

  /** Set a value, SI, in place of the design's. */
  function set(key, value) {
    const knob = live.knobs.find((each) => each.key === key);
    if (!knob) throw new Error(`${key}: changes nothing in this model`);
    values.set(key, value);
    if (knob.drive !== undefined) {
      strengths[knob.drive] = value;
      return;
    }
    for (const { field: name, places, low, slopes } of knob.changes) {
      const target = name.startsWith("opt.") ? model.opt[name.slice(4)] : model[name];
      for (const [index, place] of places.entries()) target[place] = low[index] + slopes[index] * (value - knob.lowest);
    }
  }

  /** Take one step with given controls of the motors, (motor,). */
  function step(torques) {
    const { ctrl } = view();
    for (let control = 0; control < ctrl.length; control++) {
      ctrl[control] = controls[control] >= 0 ? torques[controls[control]] : 0;
      if (brakes[control] >= 0) ctrl[control] = Math.abs(torques[brakes[control]]);
    }
    if (explicit) {
      const { qpos, ten_length: lengths, actuator_force: forces } = view();
      from.set(qpos);
      for (const [at, { control }] of live.brakeWays.entries()) braked[at] = forces[control];
      for (const [at, distance] of live.distances.entries()) measured[at] = lengths[distance];
    }
    engine.mj_step(model, data);
    stepped = true;
    if (live.gaps.length) widen();
  }

  function widen() {
    const { ten_length: lengths } = view();
    for (const [gap, length] of live.gaps) widest = Math.max(widest, Math.abs(lengths[gap] - length));
  }

  /** Work of motors in the last step: their controls times the motion of the parts they act on, (motor,). */
  function work(torques, before, into) {
    const { qvel, qpos, actuator_force: forces } = view();
    const step = model.opt.timestep;
    const travel = (place) => (step * (qvel[place] + before[place])) / 2;
    const turn = (hinge) => {
      const place = hinges.positions[hinge];
      return explicit ? qpos[place] - from[place] : travel(hinges.speeds[hinge]);
    };
    for (const [number, motor] of motors.entries()) {
      if (!torques[number]) continue;
      let way = 0;
      for (const hinge of motor.hinges) way += hinges.senses[hinge] * turn(hinge);
      for (const [dof, share] of motor.pushed.entries()) if (share) way += share * travel(dof);
      into[number] += torques[number] * way;
    }
    // minus the share that speed takes, from the engine's own forces
    for (const [at, { control, motor, way }] of live.brakeWays.entries()) {
      const force = explicit ? (braked[at] + forces[control]) / 2 : forces[control];
      for (const [dof, share, place] of way) {
        into[motor] += force * share * (explicit ? qpos[place] - from[place] : travel(dof));
      }
    }
  }

  /** Angles of all hinges in their own senses, then distances, then sums of angles, as in goals. */
  function coordinates(into) {
    const { qpos, ten_length: lengths } = view();
    let at = 0;
    for (; at < hinges.senses.length; at++) into[at] = hinges.senses[at] * qpos[hinges.positions[at]];
    for (const [number, distance] of live.distances.entries()) into[at++] = explicit && stepped ? measured[number] : lengths[distance];
    for (const parts of live.sums) for (const part of parts) into[at++] = summed(into, part);
    return into;
  }

  /** Update positions for drawing and readings; the simulation is unchanged. */
  function place() {
    engine.mj_kinematics(model, data);
    engine.mj_comPos(model, data);
    engine.mj_tendon(model, data);
    stepped = false;
    if (live.gaps.length) widen();
  }

  /** Positions of the drawn points, m. */
  function points(into) {
    const { xpos, xmat } = view();
    for (const [point, body] of anchors.bodies.entries()) {
      for (let axis = 0; axis < 3; axis++) {
        let coordinate = xpos[3 * body + axis];
        for (let other = 0; other < 3; other++) coordinate += xmat[9 * body + 3 * axis + other] * anchors.places[3 * point + other];
        into[3 * point + axis] = units.length * coordinate;
      }
    }
    return into;
  }

  /** Lengths of the tendons, in the model's units. */
  function tendonLengths(into) {
    const { site_xpos: sites } = view();
    for (const [tendon, [first, second]] of tendons.points.entries())
      into[tendon] = Math.hypot(...[0, 1, 2].map((axis) => sites[3 * second + axis] - sites[3 * first + axis]));
    return into;
  }

  /** Energies of the tendons' springs, J. */
  function tendonEnergies(into, lengths) {
    const { tendon_stiffness: linear, tendon_stiffnesspoly: higher, actuator_biasprm: muscles } = model;
    for (const [tendon, number] of tendons.numbers.entries()) {
      const spring = tendons.springs[tendon];
      const passive = [linear[number], higher[2 * number], higher[2 * number + 1]];
      // the spring of a tendon that can go slack is a muscle
      const muscle = spring ? [muscles[spring.at] / spring.width, 0, 0] : tendons.stiffness[tendon];
      const law = passive.some(Boolean) ? passive : muscle;
      const longer = Math.max(0, lengths[tendon] - restLength(tendon));
      into[tendon] = units.energy * (law[0] / 2 + (law[1] / 3 + (law[2] / 4) * longer) * longer) * longer ** 2;
    }
    return into;
  }

  /** Length below which a tendon is slack, in the model's units. */
  function restLength(tendon) {
    return model.tendon_lengthspring[2 * tendons.numbers[tendon] + 1];
  }

  /** Push a drawn point with a force, N, until the next call; release it without a force. */
  function push(point, force) {
    const { xfrc_applied: applied, xipos, xpos, xmat } = view();
    applied.fill(0);
    if (!force) return;
    const body = anchors.bodies[point];
    const unit = units.length / units.energy;
    const arm = [0, 1, 2].map((axis) => {
      let at = xpos[3 * body + axis] - xipos[3 * body + axis];
      for (let other = 0; other < 3; other++) at += xmat[9 * body + 3 * axis + other] * anchors.places[3 * point + other];
      return at;
    });
    const [x, y, z] = force.map((part) => unit * part);
    const turning = [arm[1] * z - arm[2] * y, arm[2] * x - arm[0] * z, arm[0] * y - arm[1] * x];
    applied.set([x, y, z, ...turning], 6 * body);
  }

  /** Whether the last step left plausible numbers. */
  function sound(lowest, highest) {
    const { qpos, qvel } = view();
    for (let place = 0; place < qpos.length; place++) {
      if (!Number.isFinite(qpos[place]) || (lowest[place] !== null && qpos[place] < lowest[place])) return false;
      if (highest[place] !== null && qpos[place] > highest[place]) return false;
    }
    return qvel.every(Number.isFinite);
  }

  function dispose() {
    data.delete();
    model.delete();
  }

  reset();
  return {
    strengths,
    values,
    motors: motors.length,
    tendons: tendons.numbers.length,
    coordinateCount: hinges.senses.length + live.distances.length + live.sums.flat().length,
    get velocity() {
      return view().qvel;
    },
    /** Largest gap of closed loops and supports since the start, in the model's units. */
    get widest() {
      return widest;
    },
    reset,
    set,
    step,
    work,
    coordinates,
    place,
    points,
    tendonLengths,
    tendonEnergies,
    restLength,
    push,
    sound,
    dispose,
  };
}

/** Sum of hinge angles with signs. */
export function summed(angles, part) {
  return part.reduce((sum, [hinge, sign]) => sum + sign * angles[hinge], 0);
}
