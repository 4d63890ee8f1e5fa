// A test program, not installed. It links all objects of core and no others, so linking fails if
// core needs an optional part.
int main() { return 0; }
