/* What `scallop steady` is measured against: a program that only starts and ends. */
int main(void) { return 0; }
