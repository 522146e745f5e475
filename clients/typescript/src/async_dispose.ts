/// <reference lib="esnext.disposable" preserve="true" />

/** Name of the method that `await using` calls at the end of a block. Node.js has the symbol since 18.18. */
export const asyncDispose: typeof Symbol.asyncDispose =
  Symbol.asyncDispose ?? (Symbol.for('Symbol.asyncDispose') as unknown as typeof Symbol.asyncDispose);
