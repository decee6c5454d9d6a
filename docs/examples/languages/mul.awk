# A 16.16 multiply in awk that rounds down: reads cases, writes results. Numbers are doubles of 53
# bits and products have 64, so it multiplies by halves. %d of some awks has only 32 bits, and
# int() truncates, which is the floor of what is not negative.

function number(text,  i, value) {
  for (i = 1; i <= length(text); i++) {
    value = value * 16 + index("0123456789abcdef", substr(text, i, 1)) - 1
  }
  return value
}

# Words without sign: 65536 * a + b, and the same for the other. The sign bits take away a whole
# word of the upper half.
function mul(a, b, c, d,  sum) {
  sum = a * d + b * c + int(b * d / 65536) + a * c % 65536 * 65536
  if (a >= 32768) sum -= d * 65536
  if (c >= 32768) sum -= b * 65536
  sum %= 4294967296
  return sum < 0 ? sum + 4294967296 : sum
}

{
  result = mul(number(substr($1, 1, 4)), number(substr($1, 5)), number(substr($2, 1, 4)),
               number(substr($2, 5)))
  high = int(result / 65536)
  printf "%04x%04x\n", high, result - high * 65536
}
