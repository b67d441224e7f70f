/**
 * What can go wrong with something from outside, as the catalogue of messages counts it: an id and what to print in it.
 */
export interface ProblemDetails {
  readonly name?: string;
  readonly line?: number;
  readonly column?: number;
  readonly at?: number;
  readonly excerpt?: string;
  readonly field?: string;
  readonly version?: number;
  readonly count?: number;
  readonly least?: number;
  readonly most?: number;
  readonly kept?: string;
  readonly kilobytes?: number;
  readonly width?: number;
  readonly height?: number;
  readonly code?: string;
}

export type ProblemId =
  | "image-type" | "image-broken" | "image-big" | "image-blank" | "file-type" | "files-left"
  | "svg-broken" | "svg-entities" | "svg-big" | "svg-range" | "svg-nopath"
  | "d-broken" | "d-range" | "d-big"
  | "points-rows" | "points-list" | "points-few" | "points-big"
  | "json-version" | "json-broken" | "json-big"
  | "paste-unknown"
  | "number"
  | "share-long" | "share-bad"
  | "part-missing"
  | "storage" | "engine";

export class Problem extends Error {
  override readonly name = "Problem";
  constructor(
    readonly id: ProblemId,
    readonly details: ProblemDetails = {},
  ) {
    super(id);
  }
}
