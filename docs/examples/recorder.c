/* usage: recorder LOG COUNT [WRONG_OPERATION]: logs additions of 16.16 in the format of docs/recorder.md, in C. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t page[128], pages, block, first, entries, operations, hash, prefix, records;
static FILE *file;

static uint64_t next(uint64_t h, uint64_t a, uint64_t b) {
  const unsigned __int128 p =
      (unsigned __int128)(a ^ 0x9e3779b97f4a7c00) * (b ^ 0xd1b54a32d192ed03);
  return 9 * h + ((uint64_t)p ^ (uint64_t)(p >> 64));
}
static void put_page(uint64_t type) {
  uint64_t h = 0;
  page[0] = type << 32 | 0x4c525846, page[1] = pages++, page[2] = first, page[5] = (uint64_t)1 << 63;
  for (int i = 0; i < 128; i += 2) h = next(h, page[i], page[i + 1]);
  page[7] = h;
  for (int i = 0; i < 1024; ++i) putc((int)(page[i / 8] >> i % 8 * 8 & 255), file);
  memset(page, 0, sizeof page);
}
static void put_blocks(void) {
  page[3] = operations, page[4] = entries;
  put_page(4);
  first = block, entries = 0, operations = block * 1024;
}
static void end_block(uint64_t flags) {
  prefix += hash;
  const uint64_t entry[4] = {prefix, hash, (uint64_t)1 << 63, records | flags};
  memcpy(&page[8 + 4 * entries++], entry, sizeof entry);
  hash = records = 0, ++block;
  if (entries == 30) put_blocks();
}
static uint32_t add(uint32_t a, uint32_t b, uint32_t sum) {
  hash += next(0, (uint64_t)sum << 32 | 0x1e08201, (uint64_t)b << 32 | a);
  if (++records == 1024) end_block(0);
  return sum;
}
int main(int argc, char **argv) {
  if (argc < 3 || !(file = fopen(argv[1], "wb"))) return 2;
  page[4] = 11, memcpy(page + 8, "program: C\n", 11); /* on a little-endian machine */
  put_page(1);
  const long wrong = argc > 3 ? atol(argv[3]) : -1;
  uint32_t x = 0;
  for (long i = 0; i < atol(argv[2]); ++i) x = add(x, (uint32_t)i, x + (uint32_t)i + (i == wrong));
  end_block(1 << 17);
  if (entries) put_blocks();
  return fclose(file) != 0;
}
