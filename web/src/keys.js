/**
 * Keyboard: in the player, and anywhere on the page while no control has the focus. Single letters and digits work only
 * in the player, because dictated text would press them anywhere (WCAG 2.1.4).
 */

import { make } from "./elements.js";

const OF_CLOCK = [
  ["space", "play or pause"],
  ["\u2190 \u2192", "short step back or forward"],
  ["page down, page up", "long step back or forward"],
  ["home, end", "start, end"],
];
const TURNS = "shift with \u2190 \u2192 \u2191 \u2193";
const OF_PICTURE = [
  ["+ \u2212", "nearer, further"],
  ["0", "reset the view"],
];

export function keysHelp(clips, whole) {
  const marks = clips.length === 1 ? clips[0].marks : [];
  const ofStates = marks.map((mark, index) => [String(index + 1), mark.name]);
  const rows = [...OF_CLOCK, ...ofStates, [TURNS, `turn the ${whole}`], ...OF_PICTURE].map(([keys, text]) => make("tr", {}, make("th", { scope: "row" }, keys), make("td", {}, text)));
  return make(
    "details",
    { className: "keys" },
    make("summary", {}, "Keys"),
    make("table", {}, make("tbody", {}, ...rows)),
    make("p", {}, "Space and arrow keys work unless another control has the focus. All other keys work only in the player."),
  );
}

const TURN = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** Turn or zoom the view by a key; returns whether the key does that. Some keys work only in the player. */
function look({ key, shiftKey }, eye, firstView, inside) {
  if (shiftKey && key in TURN) eye.turn(...TURN[key]);
  else if (!inside) return false;
  else if (key === "+" || key === "=") eye.zoom(1);
  else if (key === "-" || key === "\u2212") eye.zoom(-1);
  else if (key === "0") eye.show(firstView);
  else return false;
  return true;
}

/** Keys of a picture without a time line. */
export function listenToLooks(player, eye, firstView) {
  player.addEventListener("keydown", (event) => {
    if (!event.ctrlKey && !event.metaKey && !event.altKey && look(event, eye, firstView, true)) event.preventDefault();
  });
}

export function listenToKeys(player, clips, clock, eye, firstView) {
  const steps = { ArrowLeft: -1, ArrowRight: 1, PageUp: 10, PageDown: -10 };

  function go(seek) {
    clock.pause();
    seek();
  }

  function act(event, inside) {
    const { key } = event;
    if (look(event, eye, firstView, inside)) return true;
    if (key in steps) go(() => clock.step(steps[key]));
    else if (key === " ") clock.playing ? clock.pause() : clock.play();
    else if (key === "Home") go(() => clock.seek(clock.span.start));
    else if (key === "End") go(() => clock.seek(clock.span.end));
    else if (!inside) return false;
    else if (clips.length === 1 && clips[0].marks[Number(key) - 1])
      go(() => clock.seekClip(0, clips[0].marks[Number(key) - 1].time));
    else return false;
    return true;
  }

  function listen(event) {
    const at = document.activeElement;
    const inside = player.contains(at);
    if (!(inside || at === document.body || at === null) || event.ctrlKey || event.metaKey || event.altKey) return;
    // buttons use space themselves, menus and sliders nearly all keys
    if (at instanceof HTMLSelectElement || at?.dataset?.keys === "own" || (event.key === " " && /^(BUTTON|SUMMARY|A)$/.test(at?.tagName ?? "")))
      return;
    // without focus these keys scroll the page
    if (at === document.body && /^(Home|End|PageUp|PageDown)$/.test(event.key)) return;
    if (act(event, inside)) event.preventDefault();
  }

  document.addEventListener("keydown", listen);
  return () => document.removeEventListener("keydown", listen);
}
