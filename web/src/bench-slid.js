/** Changes by sliders, passed on once the sliders are at rest. */

const REST = 250; // ms

/** done: receives texts by key. */
export function makeSlid(done) {
  let settings = {};
  let timer = 0;

  function hand() {
    clearTimeout(timer);
    if (!Object.keys(settings).length) return undefined;
    const changed = settings;
    settings = {};
    return done(changed);
  }

  return {
    put(key, text) {
      settings[key] = text;
      clearTimeout(timer);
      timer = setTimeout(hand, REST);
    },
    /** Pass on pending changes at once. */
    hand,
  };
}
