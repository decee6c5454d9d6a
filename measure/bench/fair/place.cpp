// Moves the code of the other files by 336 FAIR_PLACE bytes: this file is linked first. Twelve
// places meet every multiple of 16 in a cache line three times, and are spread over a page.
asm(".text\n.skip 336 * " FAIR_PLACE);
