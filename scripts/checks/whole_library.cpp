// An empty program that is linked with the whole library (scripts/lint --odr).
int main() {}
