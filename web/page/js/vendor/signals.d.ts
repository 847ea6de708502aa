/** A value whose readers are told of its changes. */
export interface Signal<T> {
  value: T;
  peek(): T;
}
/** Without a value it has none yet. */
export function signal<T>(): Signal<T | undefined>;
export function signal<T>(value: T): Signal<T>;
export function computed<T>(of: () => T): Readonly<Signal<T>>;
/** Runs it at once, and again after each change of what it read; gives what ends it. */
export function effect(act: () => void): () => void;
export function batch<T>(act: () => T): T;
export function untracked<T>(act: () => T): T;
