// The module takes text and returns JSON or text. It does all arithmetic.

// The C++ library would write errors to a terminal, which a page does not have. 8 is the error EBADF.
const noTerminal = () => 8;

export async function loadModule(bytes) {
  const imports = { wasi_snapshot_preview1: { fd_close: noTerminal, fd_seek: noTerminal, fd_write: noTerminal } };
  const { instance } = await WebAssembly.instantiate(bytes, imports);
  const c = instance.exports;
  c._initialize();
  const text = (name, request) => {
    const space = new Uint8Array(c.memory.buffer, c.request_buffer(), c.request_size());
    const { read, written } = new TextEncoder().encodeInto(request, space);
    if (read < request.length) throw new Error(`a request of ${request.length} characters is too long`);
    const length = c[name](written);
    return new TextDecoder().decode(new Uint8Array(c.memory.buffer, c.answer_buffer(), length));
  };
  return { c, text, ask: (name, ...lines) => JSON.parse(text(name, lines.join("\n"))) };
}

// Returns the bytes in a text whose characters have 7 bits each, the highest first. Higher bits do not count.
function bytesOf(text) {
  const bytes = new Uint8Array(Math.floor(text.length * 7 / 8));
  let bits = 0;
  let held = 0;
  let at = 0;
  for (let i = 0; i < text.length; ++i) {
    bits = bits << 7 & 0x7fff | text.charCodeAt(i) & 127;
    held += 7;
    if (held >= 8) bytes[at++] = bits >> (held -= 8);
  }
  return bytes;
}

// Loads the module in this page, which is packed with gzip.
export async function embeddedModule() {
  const packed = bytesOf(document.getElementById("module").textContent);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return loadModule(await new Response(stream).arrayBuffer());
}
