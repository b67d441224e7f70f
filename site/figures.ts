/** Figures are made when they come near the window: each brings what it imports of the package, and no more. */
import type { Mount } from "./figures/stage.ts";

const FIGURES: Readonly<Record<string, () => Promise<{ mount: Mount }>>> = {
  circle: () => import("./figures/circle.ts"),
  fit: () => import("./figures/fit.ts"),
  handles: () => import("./figures/handles.ts"),
  interpolating: () => import("./figures/interpolating.ts"),
  refine: () => import("./figures/refine.ts"),
  surface: () => import("./figures/surface.ts"),
  trace: () => import("./figures/trace.ts"),
};

const NEAR = "300px";

async function show(figure: HTMLElement): Promise<void> {
  const stage = figure.querySelector<HTMLElement>(".figure-stage");
  const load = FIGURES[figure.dataset["figure"] ?? ""];
  if (stage === null || load === undefined) return;
  try {
    const { mount } = await load();
    mount(stage, figure.getAttribute("aria-label") ?? "");
    figure.dataset["ready"] = "";
  } catch (error) {
    stage.textContent = `This figure could not be drawn: ${String(error)}`;
    stage.classList.add("failed");
  }
}

const coming = new IntersectionObserver(
  (entries) => {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting) continue;
      coming.unobserve(target);
      void show(target as HTMLElement);
    }
  },
  { rootMargin: NEAR },
);
for (const figure of document.querySelectorAll<HTMLElement>("[data-figure]")) coming.observe(figure);
