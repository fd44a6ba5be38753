/** The picture of structures as files: an image, and films of their motion, with the state and the scales of colours. */

import { paintShapes } from "./drawing.js";
import { make, makeButton } from "./elements.js";
import { elementShapes } from "./element-drawing.js";
import { makeGif } from "./gif.js";
import { fileName, save } from "./saving.js";
import { beginPaper } from "./scheme.js";

const SECONDS = 8; // length of a film
const RATE = 12.5; // frames of a GIF per second; delays are in hundredths of a second
const VIDEO_RATE = 25;
const END = 0.6; // s for which a video shows the last frame
const [SMALL, LARGE, SHARP] = [640, 1280, 2400]; // width of a GIF, a video and an image, pixels
const FOOT = 30; // height of a row of text below the picture
const [MARGIN, CAPTION, GAP] = [10, 210, 24]; // beside the text, room for the caption, between scales
const LETTER = 8; // width of a letter of the caption
const VIDEOS = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm", "video/mp4"];

/**
 * Buttons that save the picture of a stage and, if the clock can be moved, its motion.
 *
 * caption: returns {text, longest}, the present moment and the number of letters of the longest one; scales: returns elements with the scales of colours.
 */
export function pictureSaves(stage, clock, caption, scales) {
  const image = makeButton("PNG", "download PNG of the picture", async () => {
    const frame = make("canvas");
    await inLightColours(stage, () => stage.drawSharp(SHARP, () => compose(frame, stage, caption(), scales(), stage.canvas.width)));
    const blob = await new Promise((done) => frame.toBlob(done, "image/png"));
    save(blob, `${fileName("picture")}.png`);
  });
  const buttons = [image];
  if (clock.seek && clock.timeAt) {
    buttons.push(filmButton("GIF", "gif", (film) => filmGif(stage, clock, caption, scales, film)));
    const type = VIDEOS.find((video) => globalThis.MediaRecorder?.isTypeSupported(video));
    const kind = type?.startsWith("video/mp4") ? "MP4" : "WebM";
    if (type && HTMLCanvasElement.prototype.captureStream) buttons.push(filmButton(kind, kind.toLowerCase(), (film) => filmVideo(stage, clock, caption, scales, film, type)));
  }
  return make("span", { className: "films", role: "group", "aria-label": "save" }, ...buttons);
}

/** A button that makes a film and displays its progress; pressed again, it stops. */
function filmButton(text, ending, filmed) {
  let film = null;
  const made = makeButton(text, `download a film as ${text}`, async () => {
    if (film) {
      film.stopped = true;
      return;
    }
    film = {
      stopped: false,
      progress: (share) => { made.textContent = `${Math.round(100 * share)} %`; },
    };
    try {
      const blob = await filmed(film);
      if (!film.stopped) save(blob, `${fileName("motion")}.${ending}`);
    } finally {
      film = null;
      made.textContent = text;
    }
  });
  return made;
}

/** Do something while the picture has the colours of a light page. */
async function inLightColours(stage, act) {
  const end = beginPaper();
  stage.paint();
  try {
    return await act();
  } finally {
    end();
    stage.paint();
  }
}

/** Show frames of the motion at shares of the film, until `next` returns null; the clock returns to its time. */
async function play(stage, clock, next, each) {
  const before = clock.time;
  clock.pause?.();
  await inLightColours(stage, async () => {
    for (let share = next(); share !== null; share = next()) {
      clock.seek(clock.timeAt(Math.min(1, share)));
      await drawn();
      each(share);
    }
  });
  clock.seek(before);
}

/** The next frame of the screen, after the clock's listeners have drawn. */
const drawn = () => new Promise((done) => requestAnimationFrame(done));

async function filmGif(stage, clock, caption, scales, film) {
  const frame = make("canvas");
  const count = Math.round(SECONDS * RATE);
  let [number, gif] = [0, null];
  await play(stage, clock, () => (film.stopped || number > count ? null : number / count), (share) => {
    compose(frame, stage, caption(), scales(), SMALL);
    gif ??= makeGif(frame.width, frame.height, 1 / RATE);
    gif.add(frame.getContext("2d", { willReadFrequently: true }).getImageData(0, 0, frame.width, frame.height).data);
    film.progress(share);
    number++;
  });
  return film.stopped ? null : new Blob([gif.bytes()], { type: "image/gif" });
}

/** Record in real time, because a recorder takes its times from the clock on the wall. */
async function filmVideo(stage, clock, caption, scales, film, type) {
  const frame = make("canvas");
  compose(frame, stage, caption(), scales(), LARGE);
  const recorder = new MediaRecorder(frame.captureStream(VIDEO_RATE), { mimeType: type, videoBitsPerSecond: 8e6 });
  const pieces = [];
  recorder.ondataavailable = ({ data }) => pieces.push(data);
  const ended = new Promise((done) => { recorder.onstop = done; });
  recorder.start();
  const began = performance.now();
  const passed = () => (performance.now() - began) / 1000;
  await play(stage, clock, () => (film.stopped || passed() > SECONDS + END ? null : passed() / SECONDS), (share) => {
    compose(frame, stage, caption(), scales(), LARGE);
    film.progress(Math.min(1, share));
  });
  recorder.stop();
  await ended;
  return new Blob(pieces, { type: type.split(";")[0] });
}

/** Draw the picture of a stage that was drawn in this frame on a canvas of a width, on white, with what is below it. */
function compose(frame, stage, caption, scales, width) {
  const { canvas, cells } = stage;
  const ratio = width / canvas.clientWidth;
  const high = Math.round(ratio * canvas.clientHeight);
  const scale = Math.max(1, ratio);
  const below = footShapes(caption, scales, width / scale);
  const foot = Math.round(scale * below.height);
  // sizes of videos are even
  const size = [2 * Math.round(width / 2), 2 * Math.round((high + foot) / 2)];
  if (frame.width !== size[0] || frame.height !== size[1]) [frame.width, frame.height] = size;
  const context = frame.getContext("2d", { willReadFrequently: true });
  context.fillStyle = "#ffffff";
  context.fillRect(0, 0, ...size);
  context.drawImage(canvas, 0, 0, width, high);
  if (cells.length > 1) for (const cell of cells) paintShapes(context, elementShapes(cell).shapes, ratio, [cell.offsetLeft, cell.offsetTop]);
  paintShapes(context, below.shapes, scale, [0, high / scale]);
}

/** The caption, and to its right or below it the scales, in as many rows as they need. */
function footShapes(caption, scales, width) {
  const shapes = [{ kind: "text", x: MARGIN, y: 20, text: caption.text, bold: true, size: 14, fill: "#16191d" }];
  let [x, y] = [caption.longest ? Math.max(CAPTION, MARGIN + LETTER * caption.longest + GAP) : MARGIN, 0];
  for (const { shapes: inner, width: wide, height } of scales.map(elementShapes)) {
    if (x > MARGIN && x + wide > width - MARGIN) [x, y] = [MARGIN, y + FOOT];
    shapes.push({ kind: "moved", x, y: y + (FOOT - height) / 2, shapes: inner });
    x += wide + GAP;
  }
  return { shapes, height: y + FOOT };
}
