/**
 * Position of a structure in its protocol: what drives it, when its stage ends, and its states; same rules as
 * forficula.dynamics.stepping.stages, step by step.
 */

const AT_ONCE = 1e-9; // steps

/** The path of a structure through a protocol; `step` advances it by one step. */
export function makeTracker(wing, protocol) {
  const torques = new Float64Array(wing.motors);
  const works = new Float64Array(wing.motors);
  const now = new Float64Array(wing.coordinateCount);
  const before = Float64Array.from(wing.velocity);
  let steps, stage, stageStart, goalSince, restSince, ends, rows, divergedAt, last, workBefore;

  /** Begin with a stage, from the present state; `until` is the index of the last stage. */
  function begin(number = 0, until = protocol.stages.length - 1) {
    [stage, last] = [number, until];
    [ends, rows, divergedAt] = [[], [], null];
    start();
    keep(true);
  }

  function restart() {
    wing.reset();
    steps = 0;
    works.fill(0);
    begin();
  }

  function start() {
    stageStart = steps;
    goalSince = restSince = -1;
    workBefore = total(works);
  }

  /** Controls of every motor in the next step: their values at the step's middle. */
  function drive() {
    torques.fill(0);
    const passed = steps - stageStart + 0.5;
    for (const number of stage === null ? [] : protocol.stages[stage].drives) {
      const { rise, torques: shares } = protocol.drives[number];
      const share = wing.strengths[number] * Math.min(passed / Math.max(rise, AT_ONCE), 1);
      for (let motor = 0; motor < torques.length; motor++) torques[motor] += share * shares[motor];
    }
    return torques;
  }

  /** Take one step; returns whether a stage, or the protocol, ended. */
  function step() {
    before.set(wing.velocity);
    wing.step(drive());
    if (!wing.sound(protocol.lowest, protocol.highest)) {
      divergedAt = (steps + 1) * protocol.timestep;
      if (stage !== null) end(null, false, false);
      stage = null;
      return true;
    }
    wing.work(torques, before, works);
    steps += 1;
    if (stage === null) return false;
    wing.coordinates(now);
    const ended = follow(protocol.stages[stage]);
    if (!ended && steps % protocol.interval === 0) keep(false);
    return ended;
  }

  function follow(asked) {
    const resting = wing.velocity.every((speed, dof) => Math.abs(speed) <= protocol.restSpeeds[dof]);
    // a structure is at rest before its torques rise
    const risen = stageStart + Math.ceil(Math.max(0, ...asked.drives.map((number) => protocol.drives[number].rise)));
    const reached = asked.kind === "bounds" ? within(now, asked) : asked.kind === "rest" && resting && steps > risen;
    if (!reached) goalSince = -1;
    else if (goalSince < 0) goalSince = steps;
    if (!resting) restSince = -1;
    else if (restSince < 0) restSince = steps;
    // a goal met only for an instant may be a bounce
    const taken = asked.kind === "bounds" ? goalSince - stageStart : 0;
    const held = reached && steps - goalSince >= Math.max(asked.hold, protocol.leastHold * taken);
    // a structure that rests short of its goal stays there, once the torques have reached their strength
    const short = resting && !reached && asked.kind === "bounds" && asked.drives.length > 0;
    const stuck = short && steps - Math.max(restSince, risen) >= protocol.stuck;
    if (!held && !stuck && steps - stageStart < asked.limit) return false;
    keep(true);
    end(held ? goalSince : null, resting, reached);
    const goesOn = held || asked.kind !== "bounds";
    if (goesOn && stage < last) {
      stage += 1;
      start();
      keep(true);
    } else stage = null;
    return true;
  }

  function end(goalStep, atRest, atGoal) {
    const found = {
      stage,
      start: stageStart,
      end: steps,
      goal: goalStep,
      atRest,
      atGoal,
      work: total(works) - workBefore,
      mean: null,
    };
    if (divergedAt === null) found.mean = meanOf(found);
    ends.push(found);
  }

  /** Store a row of the coordinates of goals, and the tendons' lengths, as a record does. */
  function keep(always) {
    if (!always && rows.length && rows.at(-1).number === steps) return;
    wing.place();
    wing.coordinates(now);
    rows.push({ number: steps, coordinates: now.slice(), lengths: wing.tendonLengths(new Float64Array(wing.tendons)) });
    const oldest = steps - protocol.window - 1;
    while (rows.length > 1 && rows[0].number < oldest) rows.shift();
  }

  /** The state at the end of a stage: means over the window, or the moment of a snap. */
  function meanOf({ stage: number, start: first, end: final, goal }) {
    const snapped = protocol.stages[number].drives.length > 0 && goal !== null;
    const from = snapped ? final : Math.max(first, final - protocol.window);
    const mine = rows.filter((row) => row.number >= from - 0.5 && row.number <= final + 0.5);
    const average = (part) => mine[0][part].map((_, place) => mine.reduce((sum, row) => sum + row[part][place], 0) / mine.length);
    const energies = mine.map((row) => wing.tendonEnergies(new Float64Array(wing.tendons), row.lengths));
    return {
      coordinates: average("coordinates"),
      energies: energies[0].map((_, tendon) => energies.reduce((sum, each) => sum + each[tendon], 0) / energies.length),
    };
  }

  restart();
  return {
    get steps() {
      return steps;
    },
    get stage() {
      return stage;
    },
    get ends() {
      return ends;
    },
    get divergedAt() {
      return divergedAt;
    },
    get works() {
      return works;
    },
    torques,
    begin,
    restart,
    step,
    release() {
      stage = null;
    },
  };
}

/** Whether coordinates are within the bounds of a goal. */
export function within(coordinates, { least, most }) {
  for (let place = 0; place < coordinates.length; place++) {
    if (least[place] !== null && !(coordinates[place] >= least[place])) return false;
    if (most[place] !== null && !(coordinates[place] <= most[place])) return false;
  }
  return true;
}

const total = (numbers) => numbers.reduce((sum, each) => sum + each, 0);
