// Emscripten's script, which web/core builds.

/** What web/core answers. */
type Core = Record<string, (given: object, deliver: unknown) => { value?: unknown; error?: string }>;
export default function create(options: object): Promise<Core>;
