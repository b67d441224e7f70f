import type { PointerSample } from "../../editor/tool.ts";

/** What a press does with the tool that it was made with: another finger may choose another meanwhile. */
export interface FitPress {
  drag(sample: PointerSample): void;
  release(sample: PointerSample): void;
}
