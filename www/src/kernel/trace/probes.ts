import type { LossCode } from "../worker-desk.ts";
import type { PictureSource, TraceAnswer, TraceRequest } from "./job.ts";

/** Pictures that are being looked at, before any of them is traced: is it one, and how large? */

export type PictureSize = readonly [width: number, height: number];

/** What a picture that cannot be looked at is refused with. */
export class ProbeError extends Error {
  override readonly name = "ProbeError";
  constructor(readonly code: string) {
    super(code);
  }
}

type ProbeRequest = Extract<TraceRequest, { kind: "probe" }>;

interface Probe {
  readonly request: ProbeRequest;
  /** Whether a worker died with it already. */
  retried: boolean;
  resolve(size: PictureSize): void;
  reject(error: ProbeError): void;
}

export class Probes {
  readonly #open = new Map<number, Probe>();
  readonly #post: (request: ProbeRequest) => void;

  constructor(post: (request: ProbeRequest) => void) {
    this.#post = post;
  }

  get none(): boolean {
    return this.#open.size === 0;
  }

  begin(id: number, picture: PictureSource): Promise<PictureSize> {
    const request = { kind: "probe", id, picture } as const;
    return new Promise((resolve, reject) => {
      this.#open.set(id, { request, retried: false, resolve, reject });
      this.#post(request);
    });
  }

  /** Says whether the answer was for one of them. */
  receive(answer: TraceAnswer): boolean {
    const probe = this.#open.get(answer.id);
    if (probe === undefined) return false;
    this.#open.delete(answer.id);
    if (answer.kind === "probed") probe.resolve([answer.width, answer.height]);
    else probe.reject(new ProbeError(answer.kind === "failed" ? answer.code : ""));
    return true;
  }

  /** A worker died with them: who has not been tried again yet, will be, unless `all` are given up. */
  died(code: LossCode, all: boolean): void {
    for (const [id, probe] of this.#open) {
      if (all || probe.retried) {
        this.#open.delete(id);
        probe.reject(new ProbeError(code));
      }
      probe.retried = true;
    }
  }

  askAgain(): void {
    for (const { request } of this.#open.values()) this.#post(request);
  }
}
