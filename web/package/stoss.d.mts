// Emscripten's script, which web/core builds.

/** What web/core answers. */
type Answer = { value?: unknown; error?: string; refusal?: import('./core.js').Refusal };
type Core = Record<string, (given: object, deliver: unknown) => Answer>;
export default function create(options: object): Promise<Core>;
