// Moves the code of the other files by 16 FAIR_PLACE bytes: this file is linked first.
asm(".text\n.skip 16 * " FAIR_PLACE);
