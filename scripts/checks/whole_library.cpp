// A program that does nothing, with which the whole library is linked.
int main() {}
