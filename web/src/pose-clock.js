/** Replacement of a clock if a reader, not time, moves a structure: the index of its pose. */

export function makePoseClock(clip) {
  const listeners = new Set();
  const span = { start: clip.start, end: clip.end, origins: [0] };
  let pose = clip.start;
  let waiting = 0;

  function changed() {
    waiting ||= requestAnimationFrame(() => {
      waiting = 0;
      for (const listener of listeners) listener();
    });
  }

  return {
    get time() {
      return pose;
    },
    span,
    clipTime: (_, moment = pose) => Math.min(clip.end, Math.max(clip.start, moment)),
    timeAt: (way) => span.start + way * (span.end - span.start),
    wayAt: (moment) => (moment - span.start) / (span.end - span.start || 1),
    onChange(listener) {
      listeners.add(listener);
      changed();
      return () => listeners.delete(listener);
    },
    seek(moment) {
      pose = Math.min(span.end, Math.max(span.start, moment));
      changed();
    },
  };
}
