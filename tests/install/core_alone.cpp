// A program of the tests, never installed, linked from all objects of core and from no others. It
// does not link if core needs a part that can be left out.
int main() { return 0; }
