/**
 * Page of one structure: its run over time, its fold path, or both. The reader chooses which one is shown. Both are
 * clips: the frames of a run are moments, those of a path are positions of a slider from 0 to 100 %. The page of a
 * landscape has curves as well, with balls at the position of the run or path.
 */

import { readClip } from "./clip.js";
import { makeClock } from "./clock.js";
import { mountCurves } from "./curves.js";
import { make } from "./elements.js";
import { makeModes } from "./modes.js";
import { mountPlayer } from "./player.js";
import { mountPlots } from "./plots.js";
import { mountReadout } from "./readout.js";
import { playOnceSeen } from "./start.js";
import { mountTryIt } from "./try-it.js";

export function showRun(data) {
  // paths on the page of a run have its mesh
  const paths = (data.paths ?? []).map((path) => ({ ...path, clips: path.clips.map((clip) => ({ ...data.clips?.[0], ...clip })) }));
  const motion = data.clips ? [{ ...data, name: "motion", title: "in time, as simulated" }] : [];
  const views = [...motion, ...paths].map(makeView);
  const page = { views };
  if (!views.length) return { ...page, curves: mountCurves(document.getElementById("curves"), data.curves) };
  const player = document.getElementById("player");
  let shown = null;
  let look;

  /** Show a view in place of another one; the direction of the eye is kept. */
  page.choose = (view) => {
    shown?.leave();
    shown = view;
    look = view.show(look) ?? look;
    Object.assign(page, view);
    modes.mark(view.name);
  };

  const modes = makeModes(data.whole, views, (name) => page.choose(views.find((view) => view.name === name)));
  if (views.length > 1) player.before(modes.element);
  page.choose(views[0]);
  if (data.clips) {
    playOnceSeen(player, page.clock);
    const path = views.find((view) => view !== views[0]);
    const fold = path && (() => {
      page.choose(path);
      player.scrollIntoView({ block: "start" });
      player.querySelector("input[type=range]").focus({ preventScroll: true });
    });
    page.trial = mountTryIt(document.getElementById("try"), views[0].clips[0], data, () => page.clock.pause(), fold);
  }
  return page;
}

/** A view of a page's structure: a clip with its clock, plots and numbers. */
function makeView(data) {
  const { name, title } = data;
  const clips = data.clips.map(readClip);
  const view = { name, title, clips, clock: null };
  let stops = [];

  view.show = (look) => {
    const place = (id) => document.getElementById(id);
    const clock = makeClock(clips, data.spans);
    if (view.clock) clock.seek(view.clock.time);
    view.clock = clock;
    view.player = mountPlayer(place("player"), clips, clock, data, look, false);
    view.curves = data.curves ? mountCurves(place("curves"), data.curves, clips, clock) : [];
    view.plots = mountPlots(place("plots"), data.plots, clips, clock);
    if (data.notes) place("player").append(...data.notes.map((note) => make("p", { className: "note" }, note)));
    const deaf = mountReadout(place("readout"), clips[0], clock, data.energy);
    stops = [deaf, () => view.player.dispose(), () => view.plots.dispose(), () => view.curves.forEach((curve) => curve.dispose())];
    return view.player.stage?.eye.look;
  };
  view.leave = () => stops.forEach((stop) => stop());
  return view;
}
