/* checkdesign: an independent checker for change covering designs.
 *
 * A change covering design is an ordered list of b blocks B_1, ..., B_b, each a
 * k-subset of a v-set, such that
 *   (1) every t-subset of the v-set (t = 2, the pairs, unless stated otherwise)
 *       lies in at least one block, and
 *   (2) consecutive blocks differ in exactly m elements, |B_i \ B_(i+1)| = m;
 *       in a circular design this includes the step from B_b back to B_1.
 * A single block makes no step; it is valid, in both kinds, if it covers all.
 *
 * The program reads text, decides (1) and (2) from the definition and prints a
 * verdict.  It shares no code with the library that makes the designs.  Input
 * format, report and exit codes are described in docs/checkdesign.md.
 * It is plain C11:  cc -std=c11 -O2 -o checkdesign checkdesign.c
 */
#include <errno.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef unsigned long long u64;
enum { VALID, INVALID, USAGE, BAD_INPUT, SYSTEM }; /* exit codes 0..4 */
enum { MAX_ELEMENTS = 65535, MAX_NAME = 255, MAX_T = 4, MAX_SHOWN = 20 };
static const u64 MAX_TABLE = 1ULL << 30; /* bytes, see make_room */

/* ---- Messages: one line on stderr, and the end --------------------------- */

/* The bytes of the UTF-8 character at s, or 0 if it is none to show: a control
 * character, one that ends a line or turns the direction of writing, or other
 * bytes.  A terminal could obey those, so names have none and messages show \xNN. */
static size_t character(const char* s) {
  static const unsigned long least[5] = {0, 0x20, 0x80, 0x800, 0x10000};
  const unsigned char* u = (const unsigned char*)s;
  size_t n = u[0] < 0x80 ? 1 : u[0] < 0xE0 ? 2 : u[0] < 0xF0 ? 3 : 4;
  unsigned long c = n == 1 ? u[0] : u[0] & (0x7FU >> n);
  if (u[0] >= 0xF8 || (u[0] >= 0x80 && u[0] < 0xC0)) return 0;
  for (size_t i = 1; i < n; i++) {
    if ((u[i] & 0xC0) != 0x80) return 0;
    c = c << 6 | (u[i] & 0x3F);
  }
  if (c < least[n] || c > 0x10FFFF || (c >= 0xD800 && c <= 0xDFFF)) return 0;
  if ((c >= 0x7F && c <= 0x9F) || (c >= 0x2028 && c <= 0x202E)) return 0;
  return c >= 0x2066 && c <= 0x2069 ? 0 : n;
}

static void say(const char* text) {
  for (size_t n; *text != '\0'; text += n) {
    n = character(text);
    if (n > 0)
      fwrite(text, 1, n, stderr);
    else
      fprintf(stderr, "\\x%02x", (unsigned)(unsigned char)*text), n = 1;
  }
}

/* Lines and columns count from 1; columns count bytes. */
struct place {
  u64 line, column;
};
static const char* input_name = "<stdin>";

static _Noreturn void stop(int code, const struct place* at, const char* format, ...) {
  char message[8192]; /* a longer path is cut */
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(message, sizeof message, format, arguments);
  va_end(arguments);
  fputs("checkdesign: ", stderr);
  if (at != NULL) {
    say(input_name);
    fprintf(stderr, ":%llu:%llu: ", at->line, at->column);
  }
  say(message);
  fputc('\n', stderr);
  exit(code);
}

/* ---- Parameters: the command line wins over the header ------------------- */

enum { V, K, CHANGE, STRENGTH, KIND, PARAMETERS };
enum { LINEAR = 1, CIRCULAR = 2 };
enum source { NONE, COMMAND, HEADER };
static const char* const key[PARAMETERS] = {"v", "k", "change", "strength", "kind"};
static const char* const range[PARAMETERS] = {"1 to 65535", "1 to 65535", "1 to 65535", "1 to 4",
                                              "linear or circular"};
static const long most[PARAMETERS] = {MAX_ELEMENTS, MAX_ELEMENTS, MAX_ELEMENTS, MAX_T, CIRCULAR};
static unsigned value[PARAMETERS] = {0, 0, 2, 2, LINEAR}; /* v, k = 0: not known yet */
static enum source given_by[PARAMETERS];

/* The value of a plain decimal number: digits only, no needless leading zero.
 * -1 for any other text.  Huge numbers come out as something above 65535. */
static long number(const char* s) {
  long n = 0;
  if (*s == '\0' || (*s == '0' && s[1] != '\0')) return -1;
  for (; *s != '\0'; s++) {
    if (*s < '0' || *s > '9') return -1;
    if (n <= MAX_ELEMENTS) n = 10 * n + (*s - '0');
  }
  return n;
}

static void give(int p, const char* text, enum source by, const struct place* at) {
  int code = by == COMMAND ? USAGE : BAD_INPUT;
  long n = number(text);
  if (p == KIND) n = strcmp(text, "linear") == 0 ? LINEAR : 0;
  if (p == KIND && strcmp(text, "circular") == 0) n = CIRCULAR;
  if (n < 1 || n > most[p]) stop(code, at, "bad value %s for %s; give %s", text, key[p], range[p]);
  if (given_by[p] == by) stop(code, at, "%s is given twice; give it once", key[p]);
  if (given_by[p] == NONE) {
    value[p] = (unsigned)n;
    given_by[p] = by;
  }
}

/* ---- Bytes and words of the input ---------------------------------------- */

static FILE* input;
static int look = EOF;             /* the current byte, or EOF at the end */
static struct place here = {1, 0}; /* where it stands */

static void advance(void) {
  here.column = look == '\n' ? 1 : here.column + 1;
  here.line += look == '\n';
  look = getc(input);
  if (look == '\r') { /* CR LF counts as LF */
    look = getc(input);
    if (look != '\n' && look != EOF)
      stop(BAD_INPUT, &here, "carriage return inside a line; end lines with LF or CR LF");
  }
  if (look == EOF && ferror(input))
    stop(SYSTEM, NULL, "%s: cannot read: %s", input_name, strerror(errno));
  if (look == 127 || (look >= 0 && look < ' ' && look != '\t' && look != '\n'))
    stop(BAD_INPUT, &here, "control byte 0x%02x; give a plain text file", (unsigned)look);
}

static char word[MAX_NAME + 1]; /* the last word, cut after 255 bytes, */
static size_t word_length;      /* its true length, */
static struct place word_at;    /* and where it began */

/* Reads the next word of the line.  False at the end of the line or the input
 * and, outside comments, at `#`; `look` then tells which. */
static bool next_word(bool in_comment) {
  while (look == ' ' || look == '\t') advance();
  word_at = here;
  word_length = 0;
  while (look != ' ' && look != '\t' && look != '\n' && look != EOF &&
         (look != '#' || in_comment)) {
    if (word_length < MAX_NAME) word[word_length] = (char)look;
    word_length++;
    advance();
  }
  word[word_length < MAX_NAME ? word_length : MAX_NAME] = '\0';
  return word_length > 0;
}

/* ---- Elements: each name gets a number, its id: 0, 1, 2, ... ------------- */

enum { SLOTS = 1 << 18 };                 /* hash table, at most a quarter full */
static unsigned slots[SLOTS];             /* 0: empty, otherwise id + 1 */
static unsigned names;                    /* ids given so far */
static char* name[MAX_ELEMENTS];          /* by id: the name, */
static struct place met_at[MAX_ELEMENTS]; /* and where it was first met */
static bool have_labels;                  /* a labels line has listed all names */
static bool all_numbers = true;           /* all names are plain decimal numbers */

/* The id of the element `word`.  A new name gets the next id if it `may_be_new`. */
static unsigned element(bool may_be_new) {
  unsigned h = 2166136261U; /* FNV-1a */
  if (word_length > MAX_NAME)
    stop(BAD_INPUT, &word_at, "name of more than %d bytes; use shorter names", MAX_NAME);
  for (size_t i = 0, n; i < word_length; i += n) {
    n = character(word + i);
    if (n == 0 || strchr(",\"", word[i]) != NULL)
      stop(BAD_INPUT, &word_at,
           "name %s with a comma, a quote or an unprintable character; rename it", word);
  }
  for (const char* s = word; *s != '\0'; s++) h = (h ^ (unsigned char)*s) * 16777619U;
  for (h %= SLOTS; slots[h] != 0; h = (h + 1) % SLOTS)
    if (strcmp(name[slots[h] - 1], word) == 0) return slots[h] - 1;
  if (!may_be_new)
    stop(BAD_INPUT, &word_at, "element %s is not among the labels; correct it or them", word);
  if (names == MAX_ELEMENTS)
    stop(BAD_INPUT, &word_at, "more than %d different elements; use fewer", MAX_ELEMENTS);
  name[names] = malloc(word_length + 1);
  if (name[names] == NULL) stop(SYSTEM, NULL, "%s: out of memory", input_name);
  memcpy(name[names], word, word_length + 1);
  if (number(word) < 0) all_numbers = false;
  met_at[names] = word_at;
  slots[h] = ++names;
  return names - 1;
}

/* With v given: numbers, if there is nothing else, must be below v, and there
 * must be at most v names. */
static void check_names(void) {
  for (unsigned id = 0; id < names && !have_labels && given_by[V] != NONE; id++) {
    if (all_numbers && number(name[id]) >= (long)value[V])
      stop(BAD_INPUT, &met_at[id], "element %s is not below v = %u; count from 0 or change v",
           name[id], value[V]);
    if (!all_numbers && id >= value[V])
      stop(BAD_INPUT, &met_at[id], "element %s is one more than v = %u; correct it or change v",
           name[id], value[V]);
  }
}

/* ---- Covering: one bit for each t-subset of the ids ---------------------- */

static u64* table;
static u64 table_words, covered, events;

/* n over r, for r = 1 to 4: exact for n <= 65535 (n^4 < 2^64), and 0 if n < r. */
static u64 choose(u64 n, unsigned r) {
  if (r == 1) return n;
  if (r == 2) return n * (n - 1) / 2;
  if (r == 3) return n * (n - 1) * (n - 2) / 6;
  return n * (n - 1) * (n - 2) * (n - 3) / 24;
}

/* The rank of a t-set a_1 < a_2 < ... < a_t of ids is the sum of choose(a_i, i).
 * This numbers the t-subsets of {0, ..., n - 1} from 0 to choose(n, t) - 1, for
 * every n at once, so that the table can grow with the number of names. */
static u64 rank_of(const unsigned set[]) {
  unsigned a[MAX_T];
  u64 rank = 0;
  for (unsigned i = 0; i < value[STRENGTH]; i++) { /* insertion sort */
    unsigned j = i;
    for (; j > 0 && a[j - 1] > set[i]; j--) a[j] = a[j - 1];
    a[j] = set[i];
  }
  for (unsigned i = 0; i < value[STRENGTH]; i++) rank += choose(a[i], i + 1);
  return rank;
}

static bool is_covered(u64 rank) {
  return rank / 64 < table_words && (table[rank / 64] >> rank % 64 & 1) != 0;
}

/* Makes the table hold one bit for every t-subset of the names. */
static void make_room(void) {
  u64 need = choose(names, value[STRENGTH]) / 64 + 1;
  u64 size = need > 2 * table_words ? need : 2 * table_words;
  if (need <= table_words) return;
  if (8 * need > MAX_TABLE)
    stop(SYSTEM, NULL, "%s: strength %u with %u elements needs %llu bytes of memory, limit %llu",
         input_name, value[STRENGTH], names, 8 * need, MAX_TABLE);
  if (8 * size > MAX_TABLE) size = need;
  table = realloc(table, 8 * (size_t)size);
  if (table == NULL) stop(SYSTEM, NULL, "%s: out of memory: %llu bytes", input_name, 8 * size);
  memset(table + table_words, 0, 8 * (size_t)(size - table_words));
  table_words = size;
}

/* The number of ones: sums of 1, then of 2, 4 and 8 neighbouring bits. */
static u64 ones(u64 bits) {
  bits -= bits >> 1 & 0x5555555555555555ULL;
  bits = (bits & 0x3333333333333333ULL) + (bits >> 2 & 0x3333333333333333ULL);
  bits = (bits + (bits >> 4)) & 0x0F0F0F0F0F0F0F0FULL;
  return bits * 0x0101010101010101ULL >> 56;
}

/* Covers the t-subsets of the ranks 64 place + i for all bits i. */
static void mark(u64 place, u64 bits) {
  if (bits == 0) return;
  covered += ones(bits & ~table[place]);
  table[place] |= bits;
}

/* mixed[] is a block: first its `fresh` elements that are not in the block
 * before, then the others.  To be covered are all t-subsets of the block with at
 * least one fresh element; the remaining ones lie in the block before as well.
 * There are two ways to go through them, for few and for many fresh elements. */
static unsigned mixed[MAX_ELEMENTS], fresh, subset[MAX_T];

/* One by one: cover(t, 0) takes those whose first member in mixed[] is fresh.
 * `left` members are still to be chosen, at mixed[from] or later. */
static void cover(unsigned left, unsigned from) {
  if (left == 0) {
    u64 rank = rank_of(subset);
    mark(rank / 64, 1ULL << rank % 64);
    return;
  }
  for (unsigned i = from; i < (left == value[STRENGTH] ? fresh : value[K]); i++) {
    subset[left - 1] = mixed[i];
    cover(left - 1, i + 1);
  }
}

/* 64 at a time: t-subsets with the same members but for the smallest, a_1, have
 * ranks base + a_1, so a set of ids, one bit each, shifted to `base` marks them.
 * cover_rows(t, k, 0, false, names) chooses all members but a_1 from the sorted
 * block[], the largest first.  `left` members are still to be chosen, at places
 * below `from`, with ids below `above`.  If a fresh element is among the others, a_1
 * may be any element of the block, and must be fresh if not. */
static u64 all[MAX_ELEMENTS / 64 + 1], only_fresh[MAX_ELEMENTS / 64 + 1];
static const unsigned* block;

static void cover_rows(unsigned left, unsigned from, u64 base, bool has_fresh, unsigned above) {
  const u64* set = has_fresh ? all : only_fresh;
  for (unsigned i = 0; left > 1 && i < from; i++) {
    unsigned id = block[i];
    bool is_fresh = (only_fresh[id / 64] >> id % 64 & 1) != 0;
    cover_rows(left - 1, i, base + choose(id, left), has_fresh || is_fresh, id);
  }
  for (unsigned id = 0; left == 1 && id < above; id += 64) {
    u64 bits = above - id < 64 ? set[id / 64] & ((1ULL << (above - id)) - 1) : set[id / 64];
    u64 rank = base + id;
    mark(rank / 64, bits << rank % 64);
    if (rank % 64 != 0) mark(rank / 64 + 1, bits >> (64 - rank % 64));
  }
}

/* Covers what the sorted `ids` of a block cover after compare() has filled mixed[].
 * Each of these t-subsets is one covering event. */
static void cover_block(const unsigned* ids) {
  events += choose(value[K], value[STRENGTH]) - choose(value[K] - fresh, value[STRENGTH]);
  if (fresh <= names / 128) { /* a row has about names / 128 words */
    cover(value[STRENGTH], 0);
    return;
  }
  block = ids;
  memset(all, 0, sizeof all[0] * (names / 64 + 1));
  memset(only_fresh, 0, sizeof only_fresh[0] * (names / 64 + 1));
  for (unsigned i = 0; i < value[K]; i++) {
    all[mixed[i] / 64] |= 1ULL << mixed[i] % 64;
    if (i < fresh) only_fresh[mixed[i] / 64] |= 1ULL << mixed[i] % 64;
  }
  cover_rows(value[STRENGTH], value[K], 0, false, names);
}

/* ---- Blocks and steps ---------------------------------------------------- */

static unsigned first[MAX_ELEMENTS], before[MAX_ELEMENTS], now[MAX_ELEMENTS];
static unsigned size;                    /* elements in now[] so far */
static u64 blocks;                       /* finished blocks */
static u64 last_in[MAX_ELEMENTS];        /* by id: the last block with it, 0 for none */
static u64 times[MAX_ELEMENTS];          /* by id: the number of blocks with it */
static u64 bad_steps, bad[MAX_SHOWN][3]; /* from, to, number of changes */

static int by_id(const void* a, const void* b) {
  unsigned x = *(const unsigned*)a, y = *(const unsigned*)b;
  return x < y ? -1 : x > y;
}

/* Merges the sorted block old[] of n elements with the sorted block new[] of k
 * to fill mixed[], the fresh elements from the front, the others from the back.
 * If n = k, then |old \ new| = |new \ old| = fresh. */
static void compare(const unsigned* old, unsigned n, const unsigned* new) {
  unsigned j = 0, back = value[K];
  fresh = 0;
  for (unsigned i = 0; i < value[K]; i++) {
    while (j < n && old[j] < new[i]) j++;
    if (j < n && old[j] == new[i])
      mixed[--back] = new[i];
    else
      mixed[fresh++] = new[i];
  }
}

static void check_step(u64 from, u64 to) {
  if (fresh != value[CHANGE] && bad_steps++ < MAX_SHOWN)
    memcpy(bad[bad_steps - 1], (u64[]){from, to, fresh}, sizeof bad[0]);
}

/* Adds `word` to the block being read. */
static void add_to_block(void) {
  unsigned limit = value[K] != 0 ? value[K] : MAX_ELEMENTS;
  u64 number = blocks + 1;
  if (size == limit)
    stop(BAD_INPUT, &word_at, "block %llu has more than %u elements; correct it%s", number, limit,
         value[K] != 0 ? ", or k" : "");
  unsigned id = element(!have_labels);
  if (last_in[id] == number)
    stop(BAD_INPUT, &word_at, "element %s is twice in block %llu; correct one", word, number);
  last_in[id] = number;
  times[id]++;
  now[size++] = id;
}

/* k is known.  A step cannot change more elements than a block has, and a subset of
 * it cannot be larger; no list of blocks would do, so that is no verdict. */
static void check_parameters(void) {
  static const struct place top = {1, 1};
  if (given_by[CHANGE] == NONE && value[K] < 2) value[CHANGE] = 1;
  for (int p = CHANGE; p <= STRENGTH; p++)
    if (value[p] > value[K])
      stop(given_by[p] == COMMAND ? USAGE : BAD_INPUT, given_by[p] == COMMAND ? NULL : &top,
           "%s = %u exceeds k = %u, the elements of a block; correct one", key[p], value[p],
           value[K]);
}

static void finish_block(void) {
  if (value[K] == 0) value[K] = size;
  if (size != value[K])
    stop(BAD_INPUT, &here, "block %llu has %u elements but k = %u; correct it, or k", blocks + 1,
         size, value[K]);
  if (blocks == 0) check_parameters();
  if (names > value[V]) check_names();
  make_room();
  qsort(now, size, sizeof now[0], by_id);
  compare(before, blocks == 0 ? 0 : size, now);
  cover_block(now);
  if (++blocks > 1)
    check_step(blocks - 1, blocks);
  else
    memcpy(first, now, size * sizeof now[0]);
  memcpy(before, now, size * sizeof now[0]);
  size = 0;
}

/* ---- Lines of the input -------------------------------------------------- */

/* A comment, from `#` to the end of the line.  Only one that has the line for
 * itself can be a header or a list of labels, and only above the first block. */
static void read_comment(bool alone) {
  advance();
  if (alone && next_word(true)) {
    bool labels = strcmp(word, "labels:") == 0;
    bool header =
        strcmp(word, "changeover") == 0 && next_word(true) && strncmp(word, "design", 6) == 0;
    if ((labels || header) && blocks > 0)
      stop(BAD_INPUT, &word_at, "header below the first block; move it to the top");
    have_labels = have_labels || labels;
    while (header && next_word(true))
      for (int p = 0; p < PARAMETERS; p++) {
        size_t n = strlen(key[p]);
        if (strncmp(word, key[p], n) == 0 && word[n] == '=')
          give(p, word + n + 1, HEADER, &word_at);
      }
    while (labels && next_word(true)) {
      unsigned known = names;
      if (strchr(word, '#') != NULL)
        stop(BAD_INPUT, &word_at, "label %s contains #; rename it", word);
      if (element(true) < known)
        stop(BAD_INPUT, &word_at, "label %s is listed twice; correct one", word);
    }
  }
  while (look != '\n' && look != EOF) advance();
}

/* All headers and labels have been read; `word` is the first element. */
static void begin_first_block(void) {
  if (word_at.line == 1 && word_at.column == 1 && strncmp(word, "\xEF\xBB\xBF", 3) == 0)
    stop(BAD_INPUT, &word_at, "byte order mark; save the file without it");
  if (have_labels && given_by[V] != NONE && value[V] != names)
    stop(BAD_INPUT, &word_at, "%u labels but v = %u; correct one", names, value[V]);
  if (have_labels) value[V] = names;
}

static void read_input(void) {
  for (advance(); look != EOF;) {
    bool alone = true;
    for (; next_word(false); alone = false) {
      if (blocks == 0 && size == 0) begin_first_block();
      add_to_block();
    }
    if (!alone) finish_block();
    if (look == '#') read_comment(alone);
    if (look == '\n') advance();
  }
  if (blocks == 0) stop(BAD_INPUT, &here, "no block found; write one block per line");
  check_names();
  if (value[V] == 0) value[V] = names;
  if (value[KIND] == CIRCULAR && blocks > 1) {   /* before[] holds B_b */
    events -= choose(value[K], value[STRENGTH]); /* B_1 was counted as if linear */
    compare(before, value[K], first);
    cover_block(first);
    check_step(blocks, 1);
  }
}

/* ---- Report -------------------------------------------------------------- */

static unsigned order[MAX_ELEMENTS]; /* the ids in the order of the report */

/* With v given, numbers are in the order 0, ..., v - 1 and those never met get
 * their names here.  Everything else is in the order in which it was met. */
static void make_order(void) {
  bool numbers = all_numbers && !have_labels && given_by[V] != NONE;
  for (unsigned n = 0; n < value[V]; n++) {
    word_length = (size_t)snprintf(word, sizeof word, "%u", n);
    order[n] = numbers ? element(true) : n;
  }
}

/* Goes through the t-subsets in order until `show` uncovered ones are shown. */
static void show_missing(unsigned left, unsigned from, u64* show) {
  if (left == 0) {
    if (is_covered(rank_of(subset))) return;
    fputs("  missing", stdout);
    for (unsigned i = value[STRENGTH]; i-- > 0;) /* ?: never met, so we know no name */
      printf(" %s", subset[i] < names ? name[subset[i]] : "?");
    putchar('\n');
    (*show)--;
    return;
  }
  for (unsigned i = from; i < value[V] && *show > 0; i++) {
    subset[left - 1] = order[i];
    show_missing(left - 1, i + 1, show);
  }
}

static void report(u64 uncovered) {
  u64 fixed = 0, show = uncovered < MAX_SHOWN ? uncovered : MAX_SHOWN;
  bool circular = value[KIND] == CIRCULAR;
  for (unsigned id = 0; id < names; id++) fixed += times[id] == blocks;
  u64 never = circular && blocks > 1 ? choose(fixed, value[STRENGTH]) : 0;
  printf("%s\nv %u\nk %u\nchange %u\nkind %s\nstrength %u\nblocks %llu\nuncovered %llu\n",
         uncovered == 0 && bad_steps == 0 ? "valid" : "invalid", value[V], value[K], value[CHANGE],
         circular ? "circular" : "linear", value[STRENGTH], blocks, uncovered);
  make_order();
  show_missing(value[STRENGTH], 0, &show);
  printf("bad-steps %llu\n", bad_steps);
  for (u64 i = 0; i < bad_steps && i < MAX_SHOWN; i++)
    printf("  step %llu %llu differs in %llu elements\n", bad[i][0], bad[i][1], bad[i][2]);
  printf("excess %llu\n", events - (covered - never));
  printf("never-newly-covered %llu\n", never);
  printf("fixed %llu\n", fixed);
}

/* The exit code, once the output is written. */
static int flushed(int code) {
  if (fflush(stdout) != 0 || ferror(stdout))
    stop(SYSTEM, NULL, "cannot write to standard output: %s", strerror(errno));
  return code;
}

/* ---- Command line -------------------------------------------------------- */

static const char help[] =
    "usage: checkdesign [-v N] [-k N] [-m N] [-t N] [-c | -l] [-q] [FILE]\n"
    "Checks the change covering design in FILE (standard input if none or -).\n"
    "  -v N  number of elements         -c  the design is circular\n"
    "  -k N  block size                 -l  the design is linear\n"
    "  -m N  elements changed per step  -q  no report, only the exit code\n"
    "  -t N  strength, 1 to 4           --help, --version\n"
    "The options win over the header of FILE, a comment line such as\n"
    "  # changeover design v=61 k=4 change=2 kind=circular strength=2\n"
    "Exit code: 0 valid, 1 invalid, 2 wrong usage, 3 bad input, 4 system error.\n";

int main(int argc, char** argv) {
  static const char letters[] = "vkmt"; /* V, K, CHANGE, STRENGTH */
  const char* path = NULL;
  bool quiet = false, options = true;

  for (int i = 1; i < argc; i++) {
    const char *a = argv[i], *letter = NULL;
    if (!options || a[0] != '-' || a[1] == '\0') {
      if (path != NULL) stop(USAGE, NULL, "more than one file; see checkdesign --help");
      path = a;
    } else if (strcmp(a, "--") == 0) {
      options = false;
    } else if (strcmp(a, "--help") == 0 || strcmp(a, "--version") == 0) {
      fputs(a[2] == 'h' ? help : "checkdesign 1.0\n", stdout);
      return flushed(VALID);
    } else if (strcmp(a, "-q") == 0) {
      quiet = true;
    } else if (strcmp(a, "-c") == 0 || strcmp(a, "-l") == 0) {
      give(KIND, a[1] == 'c' ? "circular" : "linear", COMMAND, NULL);
    } else if ((letter = strchr(letters, a[1])) != NULL) {
      if (a[2] == '\0' && i + 1 == argc)
        stop(USAGE, NULL, "%s needs a number; see checkdesign --help", a);
      give((int)(letter - letters), a[2] != '\0' ? a + 2 : argv[++i], COMMAND, NULL);
    } else {
      stop(USAGE, NULL, "unknown option %s; see checkdesign --help", a);
    }
  }
  input = stdin;
  if (path != NULL && strcmp(path, "-") != 0) {
    input_name = path;
    input = fopen(path, "rb");
    if (input == NULL) stop(SYSTEM, NULL, "%s: cannot open: %s", path, strerror(errno));
  }
  read_input();
  u64 uncovered = choose(value[V], value[STRENGTH]) - covered;
  if (!quiet) report(uncovered);
  return flushed(uncovered == 0 && bad_steps == 0 ? VALID : INVALID);
}
