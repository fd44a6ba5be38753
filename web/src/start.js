/** Playback when a page opens: once, unless its reader has asked for less motion. */

export function playOnceSeen(element, clock) {
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) return;
  const watch = new IntersectionObserver(
    (entries) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      watch.disconnect();
      clock.play();
    },
    { threshold: 0.3 },
  );
  watch.observe(element.querySelector(".picture") ?? element);
  // a reader who has used the controls needs no demonstration
  element.addEventListener("pointerdown", () => watch.disconnect(), { once: true });
}
