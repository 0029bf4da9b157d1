/** Where the values of a case file stand in its text, so that one can be changed and all else stays as it was written. */
/*! Reads TOML by toml-eslint-parser, copyright 2021 Yosuke Ota, MIT License (https://opensource.org/license/mit), with eslint-visitor-keys, copyright OpenJS Foundation and contributors, Apache License 2.0. */
import { ParseError, parseTOML, type AST } from 'toml-eslint-parser';

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

/** As much of the text from its beginning as is TOML: what is wrong with the rest the solver says. */
function readable(text: string): AST.TOMLProgram {
  for (let end = text.length; ; ) {
    try {
      return parseTOML(text.slice(0, end));
    } catch (error) {
      if (!(error instanceof ParseError)) throw error;
      // Without the line, then without those before it, where one of them opens what is never closed.
      end = Math.max(0, text.lastIndexOf('\n', Math.min(error.index, end) - 1));
    }
  }
}

function joined(table: string, key: AST.TOMLKey): string {
  const names = key.keys.map((part) => (part.type === 'TOMLBare' ? part.name : part.value));
  return (table === '' ? names : [table, ...names]).join('.');
}

function tableOf(path: string): string {
  return path.includes('.') ? path.slice(0, path.lastIndexOf('.')) : '';
}

/** Of the texts that were requested last. */
const outlines = new Map<string, Outline>();

export function outlineOf(text: string): Outline {
  const known = outlines.get(text);
  if (known) return known;
  if (outlines.size > 8) outlines.clear();
  const outline = readOutline(text);
  outlines.set(text, outline);
  return outline;
}

function readOutline(text: string): Outline {
  const outline: Outline = { values: new Map(), statements: new Map(), tables: new Map([['', 0]]), heads: new Map() };
  const lineEnd = (place: number): number => (text + '\n').indexOf('\n', place);
  const lines = ([start, end]: AST.Range): Span => ({ start: text.lastIndexOf('\n', start - 1) + 1, end: lineEnd(end) });
  const value = (path: string, { range: [start, end], ...node }: AST.TOMLContentNode): void => {
    outline.values.set(path, { start, end });
    // Counted from 1, as the solver does.
    if (node.type === 'TOMLArray') node.elements.forEach((entry, i) => value(`${path}[${i + 1}]`, entry));
    if (node.type === 'TOMLInlineTable') for (const entry of node.body) value(joined(path, entry.key), entry.value);
  };
  const statement = (table: string, node: AST.TOMLKeyValue): void => {
    value(joined(table, node.key), node.value);
    outline.statements.set(joined(table, node.key), lines(node.range));
    outline.tables.set(table, lineEnd(node.range[1]));
  };
  for (const node of readable(text).body[0].body) {
    if (node.type === 'TOMLKeyValue') statement('', node);
    else {
      const table = node.resolvedKey.map((part) => (typeof part === 'number' ? `[${part + 1}]` : `.${part}`)).join('').slice(1);
      outline.heads.set(table, lines(node.key.range));
      outline.tables.set(table, lineEnd(node.key.range[1]));
      for (const entry of node.body) statement(table, entry);
    }
  }
  return outline;
}

/** Whether a text by itself is a value: a text in quotes, a number, true or false, or a list or table of values. */
export function isValue(text: string): boolean {
  const { values, statements } = outlineOf(`x = ${text}`);
  return statements.size === 1 && values.get('x')?.end === 4 + text.length;
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
  // A table within one of a list: its key is dotted, as a head would stand for that of the last one.
  const entry = /^.*\[\d+\](?=\.)/.exec(table)?.[0];
  const after = entry === undefined ? undefined : tables.get(entry);
  if (place === undefined && entry !== undefined && after !== undefined) return `${text.slice(0, after)}\n${path.slice(entry.length + 1)} = ${value}${text.slice(after)}`;
  if (place === undefined) return `${text.replace(/\s*$/, '')}\n\n[${table}]\n${line}\n`;
  const before = text.slice(0, place);
  return `${before}${before === '' ? '' : '\n'}${line}${before === '' ? '\n' : ''}${text.slice(place)}`;
}

/** The table with which a list begins, in the one or the other way: `[[path]]` of many, `[path]` where it is alone. */
export function inList(text: string, path: string): string {
  const head = outlineOf(text).heads.get(path);
  return head ? `${text.slice(0, head.start)}${text.slice(head.start, head.end).replace(/\[([^\[\]]*)\]/, '[[$1]]')}${text.slice(head.end)}` : text;
}

/** The text with so many tables of a list: empty ones are added behind those there are, or the last ones taken out. */
export function withCount(text: string, path: string, count: number): string {
  let counted = inList(text, path);
  const has = (number: number): boolean => outlineOf(counted).heads.has(`${path}[${number}]`);
  let tables = 0;
  while (has(tables + 1)) tables += 1;
  for (; tables > count; tables -= 1) counted = without(counted, `${path}[${tables}]`);
  for (; tables < count; tables += 1) counted = `${counted.replace(/\s*$/, '')}\n\n[[${path}]]\n`;
  return counted;
}

/** The text without a key, or without a table and all that is in it; comments on lines of their own stay. */
export function without(text: string, path: string): string {
  const { statements, heads } = outlineOf(text);
  const gone = [...statements, ...heads].filter(([key]) => key === path || key.startsWith(`${path}.`)).map(([, span]) => span);
  return gone.sort((a, b) => b.start - a.start).reduce((left, { start, end }) => left.slice(0, start) + left.slice(end + 1), text);
}
