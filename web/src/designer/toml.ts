/** Where the values of a case file stand in its text, so that one can be changed and all else stays as it was written. */

interface Span {
  start: number;
  end: number;
}

export interface Outline {
  /** Of the values, by their dotted keys. */
  values: Map<string, Span>;
  /** Of whole statements, from the beginning of their line to its end. */
  statements: Map<string, Span>;
  /** Where the next key of a table goes: behind the line of its head, or of its last key. */
  tables: Map<string, number>;
  /** Of the heads of tables. */
  heads: Map<string, Span>;
}

/** Reads as far as the text is TOML: what is wrong with it the solver says. */
class Reader {
  readonly outline: Outline = { values: new Map(), statements: new Map(), tables: new Map(), heads: new Map() };
  private place = 0;

  constructor(private readonly text: string) {}

  read(): void {
    let table = '';
    const arrays = new Map<string, number>();
    this.outline.tables.set('', 0);
    for (this.skip(true); this.place < this.text.length; this.skip(true)) {
      const line = this.lineStart();
      const head = /^\[\[?/.exec(this.text.slice(this.place, this.place + 2))?.[0];
      if (head !== undefined) {
        this.place += head.length;
        table = this.key();
        if (head === '[[') {
          // Counted from 1, as the solver does.
          const count = (arrays.get(table) ?? 0) + 1;
          arrays.set(table, count);
          table = `${table}[${count}]`;
        }
        this.skip(false);
        this.expect(head === '[[' ? ']]' : ']');
        this.outline.heads.set(table, { start: line, end: this.lineEnd() });
      } else {
        const path = joined(table, this.key());
        this.value(path);
        this.outline.statements.set(path, { start: line, end: this.lineEnd() });
      }
      this.outline.tables.set(table, this.lineEnd());
      this.skipComment();
      if (this.place < this.text.length && !/[\r\n]/.test(this.text[this.place] ?? '')) throw new SyntaxError();
    }
  }

  /** An equals sign and what follows it. */
  private value(path: string): void {
    this.skip(false);
    this.expect('=');
    this.skip(false);
    const start = this.place;
    this.content(path);
    this.outline.values.set(path, { start, end: this.place });
  }

  private content(path: string): void {
    const quote = /^("""|'''|"|')/.exec(this.text.slice(this.place, this.place + 3))?.[0];
    if (quote !== undefined) this.string(quote);
    else if (this.text[this.place] === '[') this.list(path);
    else if (this.text[this.place] === '{') this.inlineTable(path);
    else {
      const plain = /^[^\s,\]}#]+( \d\d:[^\s,\]}#]*)?/.exec(this.text.slice(this.place, this.place + 200))?.[0];
      if (plain === undefined) throw new SyntaxError();
      this.place += plain.length;
    }
  }

  private string(quote: string): void {
    this.place += quote.length;
    while (!this.text.startsWith(quote, this.place)) {
      if (this.place >= this.text.length || (quote.length === 1 && this.text[this.place] === '\n')) throw new SyntaxError();
      this.place += quote.startsWith('"') && this.text[this.place] === '\\' ? 2 : 1;
    }
    this.place += quote.length;
  }

  private list(path: string): void {
    this.place += 1;
    for (let i = 0; ; i += 1) {
      this.skip(true);
      if (this.text[this.place] === ']') break;
      const entry = `${path}[${i + 1}]`;
      const start = this.place;
      this.content(entry);
      this.outline.values.set(entry, { start, end: this.place });
      this.skip(true);
      if (this.text[this.place] === ',') this.place += 1;
      else if (this.text[this.place] !== ']') throw new SyntaxError();
    }
    this.place += 1;
  }

  private inlineTable(path: string): void {
    this.place += 1;
    for (this.skip(false); this.text[this.place] !== '}'; this.skip(false)) {
      this.value(joined(path, this.key()));
      this.skip(false);
      if (this.text[this.place] === ',') this.place += 1;
      else if (this.text[this.place] !== '}') throw new SyntaxError();
    }
    this.place += 1;
  }

  private key(): string {
    const parts: string[] = [];
    do {
      if (parts.length > 0) this.place += 1;
      this.skip(false);
      const part = /^([A-Za-z0-9_-]+|"[^"\\\n]*"|'[^'\n]*')/.exec(this.text.slice(this.place, this.place + 200))?.[0];
      if (part === undefined) throw new SyntaxError();
      this.place += part.length;
      parts.push(/^["']/.test(part) ? part.slice(1, -1) : part);
      this.skip(false);
    } while (this.text[this.place] === '.');
    return parts.join('.');
  }

  private skip(lines: boolean): void {
    const blank = lines ? /\s/ : /[ \t]/;
    while (this.place < this.text.length) {
      if (blank.test(this.text[this.place] ?? '')) this.place += 1;
      else if (lines && this.text[this.place] === '#') this.skipComment();
      else return;
    }
  }

  private skipComment(): void {
    this.skip(false);
    if (this.text[this.place] === '#') this.place = this.lineEnd();
  }

  private expect(sign: string): void {
    if (!this.text.startsWith(sign, this.place)) throw new SyntaxError();
    this.place += sign.length;
  }

  private lineStart(): number {
    return this.text.lastIndexOf('\n', this.place - 1) + 1;
  }

  /** Before its line feed. */
  private lineEnd(): number {
    const end = this.text.indexOf('\n', this.place);
    return end < 0 ? this.text.length : end;
  }
}

function joined(table: string, key: string): string {
  return table === '' ? key : `${table}.${key}`;
}

function tableOf(path: string): string {
  return path.includes('.') ? path.slice(0, path.lastIndexOf('.')) : '';
}

export function outlineOf(text: string): Outline {
  const reader = new Reader(text);
  try {
    reader.read();
  } catch (error) {
    if (!(error instanceof SyntaxError)) throw error;
  }
  return reader.outline;
}

/** Whether a text by itself is a value: a text in quotes, a number, true or false, or a list or table of values. */
export function isValue(text: string): boolean {
  const { values } = outlineOf(`x = ${text}`);
  const leaf = /^(["'[{]|true$|false$|[+-]?((0|[1-9](_?\d)*)(\.\d+)?([eE][+-]?\d+)?|inf|nan)$)/;
  const whole = values.get('x');
  return whole?.end === 4 + text.length && [...values.values()].every(({ start, end }) => leaf.test(text.slice(start - 4, end - 4)));
}

/** The value of a key as it is written; nothing where the text does not give it. */
export function writtenValue(text: string, outline: Outline, path: string): string | undefined {
  const span = outline.values.get(path);
  return span && text.slice(span.start, span.end);
}

/** The text with another value of a key: in its place, or as a line of its own at the end of its table. */
export function withValue(text: string, path: string, value: string): string {
  const { values, tables } = outlineOf(text);
  const span = values.get(path);
  if (span) return text.slice(0, span.start) + value + text.slice(span.end);
  const table = tableOf(path);
  const line = `${path.slice(table === '' ? 0 : table.length + 1)} = ${value}`;
  const inline = values.get(table);
  if (inline) {
    const inner = text.slice(inline.start + 1, inline.end - 1).trim();
    return `${text.slice(0, inline.start)}{ ${inner === '' ? '' : `${inner}, `}${line} }${text.slice(inline.end)}`;
  }
  const place = tables.get(table);
  if (place === undefined) return `${text.replace(/\s*$/, '')}\n\n[${table}]\n${line}\n`;
  const before = text.slice(0, place);
  return `${before}${before === '' ? '' : '\n'}${line}${before === '' ? '\n' : ''}${text.slice(place)}`;
}

/** The table with which a list begins, in the one or the other way: `[[path]]` of many, `[path]` where it is alone. */
export function inList(text: string, path: string): string {
  const head = outlineOf(text).heads.get(path);
  return head ? `${text.slice(0, head.start)}${text.slice(head.start, head.end).replace(/\[([^\[\]]*)\]/, '[[$1]]')}${text.slice(head.end)}` : text;
}

/** The text without a key, or without a table and all that is in it; comments on lines of their own stay. */
export function without(text: string, path: string): string {
  const { statements, heads } = outlineOf(text);
  const gone = [...statements, ...heads].filter(([key]) => key === path || key.startsWith(`${path}.`)).map(([, span]) => span);
  return gone.sort((a, b) => b.start - a.start).reduce((left, { start, end }) => left.slice(0, start) + left.slice(end + 1), text);
}
