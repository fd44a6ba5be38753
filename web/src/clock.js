/**
 * The common time of a page: everything that moves follows it. A span is a part of the time line; in it every clip has
 * the time of the clock plus its origin.
 */

import { evenPace } from "./pace.js";

const STEPS = 200;

export function makeClock(clips, spans) {
  const listeners = new Set();
  let time = spans[0].start;
  let span = spans[0];
  let speed = "even";
  let playing = false;
  let lastFrame = 0;
  let waiting = 0;
  const paces = new Map();

  function pace() {
    if (!paces.has(span)) paces.set(span, evenPace(clips, span));
    return paces.get(span);
  }

  // in an enlarged span something moves most of the time
  const stretched = () => speed === "even" && span.whole;

  /** Position of a moment of the span along the time line, 0 to 1. */
  function shareAt(moment) {
    return stretched() ? pace().wayAt(moment) : (moment - span.start) / (span.end - span.start || 1);
  }

  /** The moment at a share of the time line. */
  function momentAt(share) {
    return stretched() ? pace().timeAt(share) : span.start + share * (span.end - span.start);
  }

  /** Notify all listeners once, in the next frame. */
  function changed() {
    if (!waiting) waiting = requestAnimationFrame(frame);
  }

  function frame(now) {
    waiting = 0;
    if (playing) {
      // after a long gap, as in a hidden window, continue where it stopped
      const passed = Math.min((now - lastFrame) / 1000, 0.1);
      lastFrame = now;
      advance(passed);
      waiting = requestAnimationFrame(frame);
    }
    for (const listener of listeners) listener();
  }

  function advance(seconds) {
    if (speed === "even") time = pace().timeAt(Math.min(1, pace().wayAt(time) + seconds / pace().seconds));
    else time = Math.min(span.end, time + speed * seconds);
    if (time >= span.end) playing = false;
  }

  function seek(moment) {
    time = Math.min(span.end, Math.max(span.start, moment));
    changed();
  }

  return {
    get time() {
      return time;
    },
    get span() {
      return span;
    },
    get speed() {
      return speed;
    },
    get playing() {
      return playing;
    },
    spans,
    /** The time of a clip, limited to the clip, now or at a moment of the clock. */
    clipTime: (index, moment = time) =>
      Math.min(clips[index].end, Math.max(clips[index].start, moment + span.origins[index])),
    /** Whether the time line is stretched during motion. */
    get stretched() {
      return stretched();
    },
    shareAt,
    momentAt,
    /** Position of a moment of the span along a path of even motion, 0 to 1, and its inverse. */
    wayAt: (moment) => pace().wayAt(moment),
    timeAt: (way) => pace().timeAt(way),
    /** Factor by which it is slower than real time now. */
    get slowness() {
      if (speed !== "even") return 1 / speed;
      const way = pace().wayAt(time);
      const [low, high] = [Math.max(0, way - 5e-4), Math.min(1, way + 5e-4)];
      return ((high - low) * pace().seconds) / (pace().timeAt(high) - pace().timeAt(low) || 1e-12);
    },
    onChange(listener) {
      listeners.add(listener);
      changed();
      return () => listeners.delete(listener);
    },
    seek,
    /** Seek a time of one clip, in a span that has it. */
    seekClip(index, moment) {
      if (moment < span.start + span.origins[index] || moment > span.end + span.origins[index]) {
        span =
          spans.find(
            (each) => moment >= each.start + each.origins[index] && moment <= each.end + each.origins[index],
          ) ?? spans[0];
      }
      seek(moment - span.origins[index]);
    },
    step: (steps) => seek(momentAt(shareAt(time) + steps / STEPS)),
    play() {
      if (time >= span.end) time = span.start;
      playing = true;
      lastFrame = performance.now();
      changed();
    },
    pause() {
      playing = false;
      changed();
    },
    setSpeed(value) {
      speed = value;
      changed();
    },
    setSpan(chosen) {
      span = chosen;
      seek(time < span.start || time > span.end ? span.start : time);
    },
    redraw: changed,
  };
}
