/** Fold path of a workbench's structure: its picture at once, then the path, which grows while a slider moves along it. */

import { follow } from "./bench-ask.js";
import { listenToDrags } from "./bench-drag.js";
import { firstLook } from "./camera.js";
import { readClip } from "./clip.js";
import { makeClock } from "./clock.js";
import { make } from "./elements.js";
import { mountPlayer, mountStill } from "./player.js";
import { mountPlots } from "./plots.js";
import { makePoseClock } from "./pose-clock.js";
import { mountReadout } from "./readout.js";

const FOLD = 100; // end of the slider, %

/**
 * The view has `share`, the position of the slider from 0 to 1, `complete`, whether its path is computed, and `look`, the
 * view of the camera.
 */
export function makeFold() {
  const said = make("p", { className: "note", role: "status" });
  const [player, notes, plots, readout] = ["", "notes", "", ""].map((className) => make("div", { className }));
  const element = make("div", { className: "folding" }, said, player, notes, plots, readout);
  const fold = { element, whole: "structure", share: 0, complete: false, clock: null, path: null };
  let asked = null;
  let doing = null;
  let mounted = null;
  Object.defineProperty(fold, "look", { get: () => mounted?.look });

  /**
   * Request the path of a design in place of another one; returns {shown: true} once it is built, or {refused}.
   *
   * The picture of another design is shown at once. After a change of a value, the former path stays until the first
   * part of the new one is known, so that the slider continues from its position. `begins` is called before a picture
   * is shown.
   */
  fold.show = (wanted, { fresh = false, look, begins } = {}) => {
    fold.leave();
    if (fresh) fold.share = 0;
    const mine = (doing = Object.assign(new AbortController(), { wanted }));
    const began = performance.now();
    let picture = null;
    return new Promise((settle) => {
      const hear = (line) => {
        if (line.picture) {
          picture = line.picture;
          fold.whole = picture.whole;
          begins?.();
          if (fresh || !mounted?.grow) showPicture(picture, look);
          asked = wanted;
          fold.complete = false;
          said.textContent = "Computing the fold path \u2026";
          settle({ shown: true });
        }
        if (line.path) showPath(picture, line.path, mine);
        if (line.done) said.textContent = summary(fold.path, (performance.now() - began) / 1000);
      };
      follow("fold", { ...wanted, share: fresh ? null : fold.share }, mine.signal, hear).then(
        ({ refused }) => {
          settle({ refused });
          if (!refused || doing !== mine) return;
          if (picture && mounted?.grow) showPicture(picture, look);
          if (picture) said.textContent = `No fold path is shown: ${refused}.`;
        },
        () => settle({ refused: "building was stopped" }),
      );
    });
  };

  /** Whether the picture or the path of a request is displayed. */
  fold.shows = (wanted) => mounted !== null && JSON.stringify(asked) === JSON.stringify(wanted);

  /** Stop the computation. */
  fold.leave = () => {
    doing?.abort();
    doing = null;
  };

  /** Stop a request that is refused, and continue the computation that it stopped. */
  fold.resume = () => {
    if (!doing || doing.wanted === asked) return;
    fold.leave();
    if (asked && !fold.complete) fold.show(asked);
  };

  /** Stop the computation and remove the picture. */
  fold.clear = () => {
    fold.leave();
    unmount();
    asked = null;
  };

  function unmount() {
    if (!mounted) return undefined;
    const { look } = mounted;
    mounted.dispose();
    mounted = null;
    fold.clock = fold.path = null;
    for (const place of [player, notes, plots, readout]) place.replaceChildren();
    return look;
  }

  function showPicture(picture, wanted) {
    const look = unmount() ?? wanted ?? firstLook();
    const clip = readClip(picture.clips[0]);
    const { stage } = mountStill(player, [clip], makePoseClock(clip), { ...picture, text: `${picture.shape}, as built.` }, { ...look, following: false });
    player.setAttribute("aria-label", `the ${picture.whole} as built`);
    mounted = { clip: () => clip, look: stage?.eye.look ?? look, dispose: () => stage?.dispose() };
  }

  function showPath(picture, path, mine) {
    const clip = readClip({ ...picture.clips[0], ...path.clips[0] });
    fold.path = path;
    if (mounted?.mine === mine && mounted.largest === path.energy.largest_J) mounted.grow(clip, path);
    else mountPath(clip, path, mine, picture.points);
    if (path.complete) mounted.complete(path);
    fold.complete = path.complete;
  }

  /** Display a path that grows: its clip is replaced in place. */
  function mountPath(clip, path, mine, names) {
    const focused = player.contains(document.activeElement);
    const before = mounted?.clip();
    const look = unmount() ?? firstLook();
    const moving = makeMoving(clip);
    // framed as the former picture, until the whole path is known
    if (before?.mesh.pointCount === clip.mesh.pointCount) moving.lend(before);
    const clock = makeClock([moving], path.spans);
    clock.seek(FOLD * fold.share);
    const view = mountPlayer(player, [moving], clock, path, look, false);
    view.stage?.eye.aim();
    moving.lend(null);
    let drags = null;
    const follows = () => {
      if (fold.share !== clock.time / FOLD) drags?.end();
      fold.share = clock.time / FOLD;
    };
    const stops = [() => view.dispose(), clock.onChange(follows)];
    mounted = {
      mine,
      clip: moving.now,
      look: view.stage?.eye.look ?? look,
      largest: path.energy.largest_J,
      dispose: () => stops.forEach((stop) => stop()),
      grow(next) {
        moving.replace(next);
        clock.redraw();
      },
      complete({ plots: drawn, notes: texts, energy, spans }) {
        // framing and speed are computed again for another span
        clock.setSpan({ ...spans[0] });
        notes.replaceChildren(...texts.map((text) => make("p", { className: "note" }, text)));
        const held = (pulled) => {
          element.classList.toggle("pulled", pulled);
          clock.redraw();
        };
        if (view.stage) {
          const shape = () => moving.pointsAt(clock.clipTime(0));
          drags = listenToDrags(view.stage, { moving, shape, names, asked: () => ({ ...asked, share: fold.share }), held });
          (player.querySelector(".crease-choice") ?? player.querySelector(".transport")).after(drags.element);
        }
        const charts = mountPlots(plots, drawn, [moving], clock);
        stops.push(() => charts.dispose(), mountReadout(readout, moving, clock, energy));
      },
    };
    Object.assign(fold, { clock, stage: view.stage, moving, path });
    if (focused) player.querySelector("input[type=range]").focus({ preventScroll: true });
  }

  return fold;
}

/** A clip that is replaced by another one of the same structure, and whose shape is held while it is dragged. */
function makeMoving(clip) {
  let now = clip;
  let lent = null;
  let shape = null;
  const moving = {
    now: () => now,
    replace: (next) => (now = next),
    /** Take the points of another clip of the same structure; null for those of its clip. */
    lend: (other) => (lent = other),
    /** Hold the points of a shape; null to move along the clip again. */
    hold: (points) => (shape = points),
    pointsAt(moment, into) {
      if (!shape) return (lent ?? now).pointsAt(moment, into);
      if (!into) return shape;
      into.set(shape);
      return into;
    },
    verticesAt: (moment, into) => (shape ? now.verticesOf(shape, into) : now.verticesAt(moment, into)),
  };
  return new Proxy(moving, { get: (_, name) => moving[name] ?? now[name] });
}

function summary(path, seconds) {
  const time = `${seconds.toFixed(seconds < 10 ? 1 : 0)} s`;
  return path.reached ? `The fold path was computed in ${time}.` : `The fold path was computed in ${time}; it does not reach its goal.`;
}
