/** A page that opens shows what it has move once, unless its reader has asked for less motion. */

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
  // whoever has taken hold of it needs no show
  element.addEventListener("pointerdown", () => watch.disconnect(), { once: true });
}
