/* The library of a unit on another system, in both versions of FMI: for each pair of inputs a step of 0.05 s, then pull and volume.
 * HOST LIBRARY LOCATION PATH TOKEN INPUT INPUT FORCE VOLUME; the last four are value references. */
#include <stdio.h>
#include <stdlib.h>
#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#include <string.h>
#endif

typedef void *(*instantiate2)(const char *, int, const char *, const char *, const void *, int, int);
typedef void *(*instantiate3)(const char *, const char *, const char *, char, char, char, char, const unsigned *, size_t, void *, void *, void *);
typedef int (*mode)(void *);
typedef int (*set2)(void *, const unsigned *, size_t, const double *);
typedef int (*get2)(void *, const unsigned *, size_t, double *);
typedef int (*step2)(void *, double, double, int);
typedef int (*get3)(void *, const unsigned *, size_t, double *, size_t);
typedef int (*set3)(void *, const unsigned *, size_t, const double *, size_t);
typedef int (*step3)(void *, double, double, char, char *, char *, char *, double *);

#ifdef _WIN32
static HMODULE library;
#define OF(type, name) ((type)(void *)GetProcAddress(library, name))
#define OPENED(path) LoadLibraryW(path)
#define COPIED(from, to) (void)WideCharToMultiByte(CP_UTF8, 0, from, -1, to, sizeof(to), 0, 0)
int wmain(int count, wchar_t **wide)
#else
static void *library;
#define OF(type, name) ((type)dlsym(library, name))
#define OPENED(path) dlopen(path, RTLD_NOW)
#define COPIED(from, to) (void)strncpy(to, from, sizeof(to) - 1)
int main(int count, char **wide)
#endif
{
    char words[9][1024] = {{0}}, said[3];
    unsigned in[2], out[2];
    double point[2], second[2], third[2], last;
    void *a, *b;
    for (int i = 0; i < count && i < 9; i++)
        COPIED(wide[i], words[i]);
    if (count != 9 || !(library = OPENED(wide[1])))
        return 2;
    for (int i = 0; i < 2; i++) {
        in[i] = (unsigned)atoi(words[5 + i]);
        out[i] = (unsigned)atoi(words[7 + i]);
    }
    a = OF(instantiate2, "fmi2Instantiate")("unit", 1, words[4], words[2], 0, 0, 0);
    b = OF(instantiate3, "fmi3InstantiateCoSimulation")("unit", words[4], words[3], 0, 0, 0, 0, 0, 0, 0, 0, 0);
    if (!a || !b || OF(instantiate2, "fmi2Instantiate")("unit", 1, "{another}", words[2], 0, 0, 0))
        return 3;
    if (OF(mode, "fmi2ExitInitializationMode")(a) || OF(mode, "fmi3ExitInitializationMode")(b))
        return 4;
    while (scanf("%lf %lf", &point[0], &point[1]) == 2) {
        if (OF(set2, "fmi2SetReal")(a, in, 2, point) || OF(step2, "fmi2DoStep")(a, 0.0, 0.05, 1) || OF(get2, "fmi2GetReal")(a, out, 2, second)
            || OF(set3, "fmi3SetFloat64")(b, in, 2, point, 2) || OF(step3, "fmi3DoStep")(b, 0.0, 0.05, 1, said, said + 1, said + 2, &last)
            || OF(get3, "fmi3GetFloat64")(b, out, 2, third, 2))
            return 5;
        printf("%.17g %.17g %.17g %.17g\n", second[0], second[1], third[0], third[1]);
    }
    return 0;
}
