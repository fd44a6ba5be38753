/** A clip whose present comes from the engine; its past is that of the run, by which pictures are framed. */

import { TENDONS } from "./clip.js";
import { unitFactor } from "./format.js";

const NOW = Infinity; // time that stands for the engine's present
const SEEN = 1e-4; // share of the size, of an energy, or rad: smaller changes are not visible

/** The present of a structure, as a clip and a clock for pictures and tables; `show` updates it. */
export function makeLive(clip, live, first) {
  const listeners = new Set();
  const factors = clip.readings.map(({ unit }) => (unit === "deg" ? 1 : live.units.length) * unitFactor(unit));
  // at least a second, whose unit is used for times
  const span = { start: clip.start, end: Math.max(clip.end, clip.start + 1), origins: [0], whole: true };
  let frame = first;
  let drawn = first;
  let waiting = 0;

  function changed() {
    waiting ||= requestAnimationFrame(() => {
      waiting = 0;
      for (const listener of listeners) listener();
    });
  }

  const pointsAt = (moment, into) => {
    if (moment !== NOW) return clip.pointsAt(moment, into);
    if (!into) return frame.points;
    into.set(frame.points);
    return into;
  };

  const shown = {
    ...clip,
    marks: [],
    efforts: null,
    // a reader may change the law of the membrane
    stressed: false,
    reach: clip.mesh.base.radius,
    pointsAt,
    verticesAt: (moment, into) => (moment === NOW ? clip.verticesOf(frame.points, into) : clip.verticesAt(moment, into)),
    valuesAt(name, moment, into) {
      if (moment !== NOW) return clip.valuesAt(name, moment, into);
      const at = clip.readings.findIndex((reading) => reading.name === name);
      const values = name === TENDONS ? frame.energies_J : frame.readings[at].map((value) => factors[at] * value);
      if (!into) return Float32Array.from(values);
      into.set(values);
      return into;
    },
    restLengthsAt(moment, into) {
      if (moment === NOW) into.set(frame.restLengths_m);
      else clip.restLengthsAt(moment, into);
    },
    markAt: () => undefined,
  };

  const clock = {
    get time() {
      return frame.time_s;
    },
    span,
    clipTime: (_, moment = NOW) => moment,
    timeAt: (way) => span.start + way * (span.end - span.start),
    wayAt: () => 0,
    onChange(listener) {
      listeners.add(listener);
      changed();
      return () => listeners.delete(listener);
    },
  };

  function show(next) {
    frame = next;
    if (next !== drawn && !differs(next, drawn, SEEN * shown.reach)) return;
    drawn = next;
    changed();
  }

  return {
    clip: shown,
    clock,
    show,
    get frame() {
      return frame;
    },
  };
}

/** Whether two moments look different: points by a distance, m, or energies. */
function differs(one, other, most) {
  const apart = (values, others, allowed) => values.some((value, at) => Math.abs(value - others[at]) > allowed);
  return (
    apart(one.points, other.points, most) ||
    one.readings.some((values, at) => apart(values, other.readings[at], SEEN * Math.max(1, ...values.map(Math.abs)))) ||
    apart(one.energies_J, other.energies_J, SEEN * Math.max(...other.energies_J)) ||
    apart(one.restLengths_m, other.restLengths_m, 0)
  );
}
