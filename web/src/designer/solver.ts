/** The solver in a worker of its own: the page stays at hand while it computes. */
import type { Faults } from './format';

export interface Request {
  what: string;
  [key: string]: unknown;
}

interface Job {
  request: Request;
  resolve: (answer: unknown) => void;
}

/** A request that is overtaken while it is computed for longer than this is given up, ms. */
const patience = 1500;

/** One worker. Of requests for the same thing the newest wins: those that wait behind it are never computed. */
export class Solver {
  private worker: Worker | undefined;
  private running: Job | undefined;
  private waiting: Job[] = [];
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
  ask<Answer>(request: Request): Promise<Answer | Faults | undefined> {
    return new Promise((resolve) => {
      for (const job of this.waiting.filter((one) => one.request.what === request.what)) job.resolve(undefined);
      this.waiting = this.waiting.filter((one) => one.request.what !== request.what);
      this.waiting.push({ request, resolve: resolve as Job['resolve'] });
      if (!this.running) this.next();
      else if (this.running.request.what === request.what && this.overdue === 0) this.overdue = window.setTimeout(() => this.restart(), patience);
    });
  }

  private next(): void {
    this.running = this.waiting.shift();
    if (!this.running) return;
    this.worker ??= this.start();
    this.worker.postMessage(JSON.stringify(this.running.request));
  }

  private start(): Worker {
    const url = URL.createObjectURL(new Blob([this.script], { type: 'text/javascript' }));
    const worker = new Worker(url);
    worker.onmessage = ({ data }: MessageEvent<string>) => this.answered(data);
    worker.onerror = (event) => this.answered(`!${event.message}`);
    worker.postMessage(this.module);
    return worker;
  }

  private answered(text: string): void {
    window.clearTimeout(this.overdue);
    this.overdue = 0;
    const job = this.running;
    this.next();
    if (text.startsWith('!')) job?.resolve({ faults: [{ line: 0, key: '', value: '', what: text.slice(1), advice: '', message: text.slice(1) }] });
    else job?.resolve(JSON.parse(text));
  }

  /** Gives up what is computed. */
  private restart(): void {
    this.overdue = 0;
    this.worker?.terminate();
    this.worker = undefined;
    this.running?.resolve(undefined);
    this.next();
  }
}

/** What the page carries in one of its elements. */
export function bytesIn(id: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(document.getElementById(id)?.textContent?.trim() ?? ''), (c) => c.charCodeAt(0));
}

/** Two solvers out of the page itself: one answers while the reader drags, the other takes what lasts longer. */
export async function makeSolvers(): Promise<{ quick: Solver; slow: Solver }> {
  const script = new TextDecoder().decode(bytesIn('bumpfoil-solver-script'));
  const module = await WebAssembly.compile(bytesIn('bumpfoil-solver-module'));
  return { quick: new Solver(script, module), slow: new Solver(script, module) };
}

export function isFaulty(answer: object): answer is Faults {
  return 'faults' in answer;
}
