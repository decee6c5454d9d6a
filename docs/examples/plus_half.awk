# "Add a half and cut off", as a subject of `fixproof check`: the product of the cases on standard
# input. Numbers of awk are doubles.

function unsigned(word,  i, value) {
  value = 0
  for (i = 1; i <= 8; i++) value = value * 16 + index("0123456789abcdef", substr(word, i, 1)) - 1
  return value
}
function signed(word,  value) {
  value = unsigned(word)
  return value < 2147483648 ? value : value - 4294967296
}
# Modulo 2^32, in two halves: not every awk prints 32 bits in hex.
function hex(value,  high) {
  value %= 4294967296
  if (value < 0) value += 4294967296
  high = int(value / 65536)
  return sprintf("%04x%04x", high, value - high * 65536)
}

{ print hex(int(signed($1) * signed($2) / 65536 + 0.5)) }
