/* The library of a unit on Windows: pull and volume at the points of its input, in both versions of FMI. HOST LIBRARY LOCATION PATH TOKEN */
#include <stdio.h>
#include <windows.h>

typedef void *(*instantiate2)(const char *, int, const char *, const char *, const void *, int, int);
typedef void *(*instantiate3)(const char *, const char *, const char *, char, char, void *, void *);
typedef int (*set2)(void *, const unsigned *, size_t, const double *);
typedef int (*get2)(void *, const unsigned *, size_t, double *);
typedef int (*get3)(void *, const unsigned *, size_t, double *, size_t);
typedef int (*set3)(void *, const unsigned *, size_t, const double *, size_t);

static HMODULE library;
#define OF(type, name) ((type)(void *)GetProcAddress(library, name))

int wmain(int count, wchar_t **wide)
{
    char words[5][1024];
    const unsigned in[2] = {0, 1}, out[2] = {3, 5};
    double point[2], second[2], third[2];
    void *a, *b;
    for (int i = 0; i < count && i < 5; i++)
        (void)WideCharToMultiByte(CP_UTF8, 0, wide[i], -1, words[i], sizeof(words[i]), 0, 0);
    if (count != 5 || !(library = LoadLibraryW(wide[1])))
        return 2;
    a = OF(instantiate2, "fmi2Instantiate")("unit", 1, words[4], words[2], 0, 0, 0);
    b = OF(instantiate3, "fmi3InstantiateModelExchange")("unit", words[4], words[3], 0, 0, 0, 0);
    if (!a || !b || OF(instantiate2, "fmi2Instantiate")("unit", 1, "{another}", words[2], 0, 0, 0))
        return 3;
    while (scanf("%lf %lf", &point[0], &point[1]) == 2) {
        if (OF(set2, "fmi2SetReal")(a, in, 2, point) || OF(get2, "fmi2GetReal")(a, out, 2, second)
            || OF(set3, "fmi3SetFloat64")(b, in, 2, point, 2) || OF(get3, "fmi3GetFloat64")(b, out, 2, third, 2))
            return 4;
        printf("%.17g %.17g %.17g %.17g\n", second[0], second[1], third[0], third[1]);
    }
    return 0;
}
