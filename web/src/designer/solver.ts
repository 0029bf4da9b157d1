/** The solver in workers of its own: the page stays at hand while it computes. */
import type { InputErrors } from './format';

export interface Request {
  what: string;
  [key: string]: unknown;
}

interface Job {
  /** For the same thing, one for each of the first workers. */
  requests: Request[];
  /** By worker, as they come. */
  answers: Map<number, unknown>;
  resolve: (answers: unknown[] | undefined) => void;
}

/** A request that is overtaken is given up once it has been computed for this long, ms. */
const patience = 1500;

/** A change is taken for settled when no other follows for so long, ms. */
export const settled = 300;

function subject(job: Job): string | undefined {
  return job.requests[0]?.what;
}

/** One worker, or several for requests in parts. Of requests for the same thing the newest wins: those that wait behind it are never computed. */
export class Solver {
  private workers: Worker[] = [];
  private running: Job | undefined;
  private waiting: Job[] = [];
  /** When the one that is running began. */
  private began = 0;
  private overdue = 0;

  /**
   * @param script  what Emscripten wrote, and the worker's part behind it
   * @param module  the compiled solver, which workers share
   */
  constructor(
    private readonly script: string,
    private readonly module: WebAssembly.Module,
  ) {}

  /** The answer; nothing where a later request for the same came first. */
  async ask<Answer>(request: Request): Promise<Answer | InputErrors | undefined> {
    return (await this.askTogether<Answer>([request]))?.[0];
  }

  /** The answers to the parts of a request, each computed in a worker of its own; nothing where a later one came first. */
  askTogether<Answer>(requests: Request[]): Promise<(Answer | InputErrors)[] | undefined> {
    return new Promise((resolve) => {
      const job: Job = { requests, answers: new Map(), resolve: resolve as Job['resolve'] };
      const overtaken = (one: Job): boolean => subject(one) === subject(job);
      for (const one of this.waiting.filter(overtaken)) one.resolve(undefined);
      this.waiting = [...this.waiting.filter((one) => !overtaken(one)), job];
      if (!this.running) this.next();
      else if (overtaken(this.running) && this.overdue === 0) this.overdue = window.setTimeout(() => this.restart(), Math.max(0, this.began + patience - performance.now()));
    });
  }

  private next(): void {
    this.running = this.waiting.shift();
    this.began = performance.now();
    this.running?.requests.forEach((request, place) => {
      const worker = (this.workers[place] ??= this.start(place));
      worker.postMessage(JSON.stringify(request));
    });
  }

  private start(place: number): Worker {
    const url = URL.createObjectURL(new Blob([this.script], { type: 'text/javascript' }));
    const worker = new Worker(url);
    worker.onmessage = ({ data }: MessageEvent<string>) => this.answered(place, data);
    worker.onerror = (event) => this.answered(place, `!${event.message}`);
    worker.postMessage(this.module);
    return worker;
  }

  private answered(place: number, text: string): void {
    const job = this.running;
    if (!job) return;
    job.answers.set(place, text.startsWith('!') ? { errors: [{ line: 0, key: '', value: '', what: text.slice(1), advice: '', message: text.slice(1) }] } : JSON.parse(text));
    if (job.answers.size < job.requests.length) return;
    window.clearTimeout(this.overdue);
    this.overdue = 0;
    this.next();
    job.resolve(job.requests.map((_, i) => job.answers.get(i)));
  }

  /** Gives up what is computed. */
  private restart(): void {
    this.overdue = 0;
    for (const worker of this.workers) worker.terminate();
    this.workers = [];
    this.running?.resolve(undefined);
    this.next();
  }
}

/** What the page carries in one of its elements. */
export function bytesIn(id: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(document.getElementById(id)?.textContent?.trim() ?? ''), (c) => c.charCodeAt(0));
}

/** What was compressed by gzip. */
async function unpacked(bytes: Uint8Array<ArrayBuffer>): Promise<ArrayBuffer> {
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}

/** Solvers out of the page itself: one for loops, one for other quick answers while the reader drags, one for what lasts longer. */
export async function makeSolvers(): Promise<{ loops: Solver; quick: Solver; slow: Solver }> {
  const script = new TextDecoder().decode(bytesIn('bumpfoil-solver-script'));
  const module = await WebAssembly.compile(await unpacked(bytesIn('bumpfoil-solver-module')));
  return { loops: new Solver(script, module), quick: new Solver(script, module), slow: new Solver(script, module) };
}

/** Most columns per pitch and rows of the film for answers that come first. */
export const quickMesh = [4, 5];

export function isRefused(answer: object): answer is InputErrors {
  return 'errors' in answer;
}
