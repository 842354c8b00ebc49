// Bytes as letters that a script can hold.

/** The bytes of a Base64 text. A loop, since Uint8Array.from would take four seconds for all of the compiler. */
export function bytesOf(base64) {
  const letters = atob(base64);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes;
}
