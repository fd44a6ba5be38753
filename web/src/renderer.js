/**
 * Renderers with their canvases. The one that a picture leaves is kept for the next picture of the page: a new renderer
 * compiles all shaders again, which takes longer than everything else that a new picture needs.
 */

import { WebGLRenderer } from "three";
import { make } from "./elements.js";
import { makeProcessorRenderer } from "./processor-renderer.js";

let kept = null;

/** Return a renderer, its canvas, and whether it has WebGL; without WebGL the processor draws. */
export function takeRenderer() {
  const former = kept;
  kept = null;
  if (former && !former.renderer.getContext?.().isContextLost()) return former;
  former?.renderer.dispose();
  const canvas = make("canvas", { tabIndex: 0, role: "img" });
  const context = canvas.getContext("webgl2", { antialias: true, alpha: true, stencil: true });
  const renderer = context ? new WebGLRenderer({ canvas, context, antialias: true, alpha: true, stencil: true }) : makeProcessorRenderer(canvas);
  return { renderer, canvas, webgl: context !== null };
}

/**
 * Keep a renderer whose picture is disposed of, or free its memory if another one is kept.
 *
 * Materials of a picture need no memory of the graphics chip and must not be disposed of: with the last material of a
 * shader, three.js would delete the shader.
 */
export function leaveRenderer(taken) {
  taken.canvas.remove();
  taken.canvas.className = "";
  if (!kept) {
    kept = taken;
    return;
  }
  taken.renderer.dispose();
  taken.renderer.forceContextLoss();
}
