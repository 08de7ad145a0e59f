/* A program that truegap asks: the length of a spring under a load. The protocol is in docs/command-base.md. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(void) {
    char word[32], text[256], *name;
    double *force = NULL, k = 0, rest = 0, cell;
    int rows = 0, column, columns, force_at;
    while (scanf("%31s", word) == 1) {
        if (!strcmp(word, "truegap")) {
            scanf("%*d");
            puts("truegap 1");
        } else if (!strcmp(word, "inputs") && scanf("%d", &rows) == 1) {
            fgets(text, sizeof text, stdin); /* names of the columns */
            columns = 0, force_at = -1;
            for (name = strtok(text, " \n"); name; name = strtok(NULL, " \n"), columns++)
                if (!strcmp(name, "force_n")) force_at = columns;
            force = realloc(force, rows * sizeof *force);
            for (int row = 0; row < rows; row++)
                for (column = 0; column < columns && scanf("%lf", &cell) == 1; column++)
                    if (column == force_at) force[row] = cell;
        } else if (!strcmp(word, "ask")) {
            fgets(text, sizeof text, stdin); /* k=2.0 rest=1.0 */
            for (name = strtok(text, " \n"); name; name = strtok(NULL, " \n"))
                if (sscanf(name, "k=%lf", &k) != 1) sscanf(name, "rest=%lf", &rest);
            printf("answer %d\n", rows);
            for (int row = 0; row < rows; row++) printf("%.17g\n", rest + force[row] / k);
        }
        fflush(stdout);
    }
    return 0;
}
