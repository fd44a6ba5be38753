/** What sliders have changed, handed on once they are at rest. */

const REST = 250; // ms

/** done: told texts by key. */
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
    /** Hand on at once what there is. */
    hand,
  };
}
