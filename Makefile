# The course's commands; `make help` explains them. Nothing but make, a C11
# compiler and stb is needed. Works with GNU make 3.81 and later.

#: make             build every chapter and draw its picture, build/NN-name.png
#: make 04          the same for chapter 4;  ARGS="--size 320x240 --help": its options
#: make mine-04     the same with your own exercises in place of the solutions
#:                  MINE=all: those of every chapter;  MINE="04-sphere 05-triangle": of these
#: make test-04     the chapter's tests on your exercises
#:                  T=far: only the tests whose name contains it;  T=nearest_root, an
#:                  exercise: only its tests, and with all other exercises solved
#:                  SAN=1: a crash or a wrong index says in which line
#: make hint-04     a hint for every exercise;  N=2, N=3: more of it;  T=nearest_root: for this one
#: make progress    every exercise: not started, wrong or right; the homework: begun or not
#: make homework    your own ray tracer, exercises/homework/, checked stage by stage
#:                  T=depth: one stage;  TEST_SECONDS=600: more than 120 s for a picture
#: make test        every chapter's tests, on the solutions;  TAP=1;  JUNIT=file
#: make measure-04  error and cost of the chapter's variants: a table, CSV, plots;  N=3: of each
#:                  cost the best of three runs
#: make measure     the same for all, and one page: build/measure/index.html
#: make slides      both decks, HTML and PDF, build/slides/: needs npm and chromium
#: make clean       remove build/
#:
#: For those who work on the course:
#: make test-solutions-04   one chapter's tests on its solutions
#: make seeds-09    one chapter's tests on its solutions with N=100 different seeds
#: make grade SUBMISSIONS=dir   the homework of every folder in dir: a table, and
#:                  build/grade/junit.xml
#: make handout     build/handout: the course without solutions/ and wrong answers
#: make homework-reference      make tests/homework/reference.pfm again: half an hour
#: make soak        N=1e8 rays through the pictures of chapters 09 to 11: are all samples light?
#: make fuzz        mutated texts through the OBJ reader for SECONDS=60; needs clang with libFuzzer
#: make leaks       N=1e8 rays at the edges and corners of closed meshes: does one leak?
#: make check       tests, stubs, wrong answers, homework, texts, pictures, slides, staircase, format
#: make texts       renew the measured tables and the pictures in the texts
#: make format      lay out all C code
#:
#: With all of them: REAL=double for double instead of float, CC=clang, SAN=1 for
#: the sanitizers, EXERCISES=dir for another folder than exercises/, make -j2.

ifeq ($(origin CC),default)
CC := cc
endif
REAL ?= float
EXERCISES ?= exercises
ifeq ($(filter $(REAL),float double),)
$(error REAL is float or double, not "$(REAL)")
endif

# ---- flags -------------------------------------------------------------------
# One folder of objects for each flavour: mixed objects would give wrong programs.
F := $(notdir $(firstword $(CC)))-$(REAL)$(if $(SAN),-san)$(if $(TIMED),-timed)
B := build/$F

ifeq ($(origin STB_CFLAGS),undefined)
STB_CFLAGS := $(shell sh tests/tools/stb.sh)
endif
ifeq ($(origin OPENMP),undefined)
OPENMP := $(shell sh tests/tools/openmp.sh $(CC))
endif
ifeq ($(origin LTO),undefined)
LTO := $(if $(TIMED)$(SAN),,$(shell sh tests/tools/lto.sh $(CC)))
endif
ifeq ($(origin CFLAGS),undefined)
CFLAGS := $(if $(TIMED),-O3 -march=native -flto,-O2) -g
endif
comma := ,
# -ffp-contract=off: the same bits everywhere. -fno-tree-slp-vectorize: gcc 12 at -O2 loses
# the rounding of struct fields in a tail call ((float)a.x arrives as a.x).
STRICT := -std=c11 -D_POSIX_C_SOURCE=200809L -ffp-contract=off -fno-tree-slp-vectorize -I. \
	-Wall -Wextra -Wpedantic -Wshadow $(if $(WERROR),-Werror) $(if $(OPENMP),,-Wno-unknown-pragmas) \
	$(if $(filter double,$(REAL)),-DREAL_IS_DOUBLE) \
	$(if $(SAN),-fsanitize=address$(comma)undefined -fno-sanitize-recover=all)
COMPILE = @mkdir -p $(@D) && $(CC) $(STRICT) $(OPENMP) $(STB_CFLAGS) $(CFLAGS) $(LTO) -MMD -MP
# A function without prototype or without return compiles, in C, and goes wrong later: in a
# student's code it stops here.
STOP    = -Werror=implicit-function-declaration -Werror=return-type
LINK    = @mkdir -p $(@D) && $(CC) $(STRICT) $(OPENMP) $(CFLAGS) $(FAST) -o $@ $(filter %.o,$^) -lm
# Programs that trace paths are optimised across files, which takes seconds and makes them
# twice as fast.
FAST = $(if $(LTO),$(if $(filter $B/09-% $B/1% $B/mine/09-% $B/mine/1%,$@),-flto=auto,-fno-lto))
LINK_OWN = @mkdir -p $(@D) && sh tests/tools/link.sh $(CC) $(STRICT) $(OPENMP) $(CFLAGS) $(FAST) -o $@ $(filter %.o,$^) -lm

# ---- what there is -----------------------------------------------------------
CHAPTERS := $(patsubst chapters/%/,%,$(sort $(wildcard chapters/*/)))
number = $(firstword $(subst -, ,$1))

# UPTO_c: chapter c and all before it, the ones whose modules it may use.
$(foreach c,$(CHAPTERS),$(eval SO_FAR += $c)$(eval UPTO_$c := $(SO_FAR)))

# MINE: the chapters whose exercises are the student's own.
MINE_CHAPTERS := $(if $(filter all,$(MINE)),$(CHAPTERS),$(MINE))
ifneq ($(filter-out $(CHAPTERS),$(MINE_CHAPTERS)),)
$(error MINE: no chapter "$(filter-out $(CHAPTERS),$(MINE_CHAPTERS))"; there are: $(CHAPTERS))
endif

# Where the answers lie that others build on: in a handout there are no solutions, and the
# student's own stand for them.
SOLVED := $(if $(wildcard solutions/*/*.c),solutions,$(EXERCISES))

# ---- which objects make a program ----------------------------------------------
# A chapter's module declares its exercises and calls them. Each is defined once,
# by a file in solutions/ or by one in $(EXERCISES)/: exactly one of them is linked.
OWN     := $B/own/$(subst /,_,$(EXERCISES))
COMMON  := $(patsubst %.c,$B/obj/%.o,$(wildcard common/*.c))
CHECK   := $(patsubst %.c,$B/obj/%.o,$(filter-out %/check-self.c %/check-fixtures.c,$(wildcard tests/check*.c)))
modules  = $(patsubst %.c,$B/obj/%.o,$(filter-out %/main.c %/measure.c,$(foreach c,$(UPTO_$1),$(wildcard chapters/$c/*.c))))
answers  = $(patsubst %.c,$B/obj/%.o,$(wildcard $(SOLVED)/$1/*.c))
own      = $(patsubst $B/obj/$(SOLVED)/%,$(OWN)/%,$(call answers,$1))
solved   = $(foreach c,$(UPTO_$1),$(call answers,$c))
# The student's answers of the chapters in MINE, of just this one if that is not set.
mine     = $(foreach c,$(UPTO_$1),$(if $(filter $c,$(or $(MINE_CHAPTERS),$1)),$(call own,$c),$(call answers,$c)))
# Every solution but the one of exercise $2, which another object stands in for.
all_but  = $(filter-out $B/obj/$(SOLVED)/$1/$2.o,$(call solved,$1))
# tests/04-sphere/wrong/nearest_root-larger.c answers the exercise nearest_root.
exercise = $(firstword $(subst -, ,$(notdir $(basename $1))))
exercises = $(notdir $(basename $(wildcard $(SOLVED)/$1/*.c)))
# KIND=right: those alone.
variants = $(wildcard $(foreach k,$(or $(KIND),wrong right),tests/$1/$k/*.c))

# ---- commands --------------------------------------------------------------------
.PHONY: all help test check texts progress measure format clean FORCE
.SECONDARY:
.SUFFIXES:

all: $(CHAPTERS:%=build/%.png)
	@echo "The pictures:"; for picture in $^; do echo "  $$picture"; done

help:
	@sed -n 's/^#: \{0,1\}//p' Makefile

# $1 chapter (04-sphere), $2 its number (04)
define chapter_rules
.PHONY: $2 mine-$2 test-$2 test-solutions-$2 seeds-$2 hint-$2 measure-$2
TESTED_$1 := $B/obj/tests/$1.o $(CHECK) $(call modules,$1) $(COMMON)

$B/$1: $B/obj/chapters/$1/main.o $(call modules,$1) $(call solved,$1) $(COMMON)
	$$(LINK)
$B/mine/$1: $B/obj/chapters/$1/main.o $(call modules,$1) $(call mine,$1) $(COMMON) FORCE
	$$(LINK_OWN)
$B/measure/$1: $B/obj/chapters/$1/measure.o $(call modules,$1) $(call solved,$1) $(COMMON)
	$$(LINK)
$B/test/$1: $$(TESTED_$1) $(call solved,$1)
	$$(LINK)
$B/test-mine/$1: $$(TESTED_$1) $(call mine,$1) FORCE
	$$(LINK_OWN)

build/$1.png: $B/$1
	@ln -sf $F/$1 build/$1
	$B/$1 --out $$@ $$(ARGS)
$2: $B/$1
	@ln -sf $F/$1 build/$1
	$B/$1 --out build/$1.png $$(ARGS)
	@echo "The picture: build/$1.png"
mine-$2: $B/mine/$1
	@mkdir -p build/mine
	@sh tests/tools/mine.sh test-$2 $B/mine/$1 --out build/mine/$1.png $$(ARGS)
	@echo "The picture: build/mine/$1.png"
# T=exercise: that one is the student's and all others are solved, so none is in its way.
test-$2: $(if $(filter $T,$(call exercises,$1)),$B/one/$1/$T,$B/test-mine/$1)
	@SOLUTIONS=$(if $(filter solutions,$(SOLVED)),solutions/$1/) $$<
test-solutions-$2: $B/test/$1
	@$B/test/$1
seeds-$2: $B/test/$1
	@sh tests/tools/seeds.sh $$< $$(or $$N,100)
hint-$2:
	@sh tests/tools/hint.sh $1 "$$(or $$(N),1)" "$$(T)"

build/measure/$1.$(REAL).csv: $B/measure/$1 FORCE
	@mkdir -p $$(@D)
	sh common/best.sh $$(or $$N,1) $B/measure/$1 > $$@.new
	@mv $$@.new $$@
measure-$2:
	@$$(MAKE) --no-print-directory TIMED=1 REAL=float build/measure/$1.float.csv
	@$$(MAKE) --no-print-directory TIMED=1 REAL=double build/measure/$1.double.csv
	@cat build/measure/$1.float.csv build/measure/$1.double.csv > build/measure/$1.csv
	@sh common/plot.sh build/measure/$1.csv build/measure
endef
$(foreach c,$(CHAPTERS),$(eval $(call chapter_rules,$c,$(call number,$c))))

# One exercise of the student, all others solved: $1 chapter, $2 exercise.
define one_rule
$B/one/$1/$2: $(TESTED_$1) $(OWN)/$1/$2.o $(call all_but,$1,$2)
	$$(LINK_OWN)
ONE += $B/one/$1/$2
endef
# One answer of tests/NN-name/wrong/ or right/: $1 chapter, $2 its file.
define variant_rule
$B/$(basename $2): $(TESTED_$1) $B/obj/$(basename $2).o $(call all_but,$1,$(call exercise,$2))
	$$(LINK)
VARIANTS += $B/$(basename $2)
endef
$(foreach c,$(CHAPTERS),$(foreach e,$(call exercises,$c),$(eval $(call one_rule,$c,$e))))
$(foreach c,$(CHAPTERS),$(foreach f,$(call variants,$c),$(eval $(call variant_rule,$c,$f))))

$B/check-fixtures: $B/obj/tests/check-fixtures.o $(CHECK) $(COMMON)
	$(LINK)
$B/test/check: $B/obj/tests/check-self.o $(CHECK) $(COMMON)
	$(LINK)

$B/test/common: $B/obj/tests/common.o $(CHECK) $(COMMON)
	$(LINK)

test: $B/check-fixtures $B/test/check $B/test/common $(CHAPTERS:%=$B/test/%)
	@FIXTURES=$B/check-fixtures sh tests/tools/run.sh $(filter $B/test/%,$^)

# An answer that does not compile must not hide the others: -k, and the report tells.
progress:
	@mkdir -p build && rm -rf $B/one
	@$(MAKE) -k --no-print-directory one > build/progress.log 2>&1 || true
	@{ $(foreach c,$(CHAPTERS),$(foreach e,$(call exercises,$c),echo "$c $e $B/one/$c/$e";)) } > build/progress.list
	@EXERCISES=$(EXERCISES) sh tests/tools/progress.sh build/progress.list
.PHONY: one
one: $(ONE)

# One after the other, also under -j: they take times.
measure:
	@$(foreach c,$(CHAPTERS),$(MAKE) -j1 --no-print-directory measure-$(call number,$c) &&) true
	@echo "All tables and plots: build/measure/index.html"

# ---- the homework -----------------------------------------------------------------------
# A program of the student's own; a warning does not stop it. It may use anything of the
# course, so all of it lies in a library: what the student defines comes first, and what is not
# asked for is left out.
HW        := $B/homework
HW_COURSE := $(HW)/course.a
HW_CHECK  := $(HW)/check
HW_JUDGES := $(filter-out tests/homework/reference.c,$(wildcard tests/homework/*.c))
HW_BUILD   = $(CC) $(filter-out -Werror,$(STRICT)) -Wno-unused-parameter $(STOP) $(OPENMP) \
	-pthread $(STB_CFLAGS) $(CFLAGS)

$(HW_COURSE): $(COMMON) $(call modules,$(lastword $(CHAPTERS))) $(call solved,$(lastword $(CHAPTERS)))
	@mkdir -p $(@D) && rm -f $@ && ar rc $@ $^ && ranlib $@
$(HW_CHECK): $(patsubst %.c,$B/obj/%.o,tests/homework.c $(HW_JUDGES)) $(CHECK) $(COMMON)
	$(LINK)
$(HW)/reference: $(patsubst %,$B/obj/tests/homework/%.o,reference pfm program) $(CHECK) $(COMMON)
	$(LINK)
$(HW)/solution: $(patsubst %.c,$B/obj/%.o,$(wildcard solutions/homework/*.c)) $(COMMON)
	$(LINK)

.PHONY: homework hint-homework grade handout check-homework homework-reference
homework: $(HW_CHECK) $(HW_COURSE)
	@sh tests/tools/homework.sh $(EXERCISES)/homework build/homework $(HW_CHECK) $(HW_COURSE) $(HW_BUILD)
hint-homework:
	@echo "What make homework says is the hint. The task: $(EXERCISES)/homework/README.md; how each part is done: chapters 02 to 10."
grade: $(HW_CHECK) $(HW_COURSE)
	@sh tests/tools/grade.sh "$(SUBMISSIONS)" build/grade $(HW_CHECK) $(HW_COURSE) $(HW_BUILD)
handout:
	@sh tests/tools/handout.sh build/handout

# tests/homework/wrong/path-twice.c stands in for path.c of the solution, all-x.c for all of it.
# With few samples: mistakes must be found without many.
HW_VARIANTS := $(wildcard tests/homework/wrong/*.c tests/homework/right/*.c)
HW_PARTS     = $(patsubst %.c,$(HW)/obj/%.o,$(if $(filter all,$(call exercise,$1)),,$(filter-out \
	solutions/homework/$(call exercise,$1).c,$(wildcard solutions/homework/*.c))))
$(HW)/obj/%.o: %.c | $B/.setup
	$(COMPILE) -DSAMPLES=24 -c -o $@ $<
define homework_rule
$(HW)/$(basename $1)/raytracer: $(HW)/obj/$(basename $1).o $(call HW_PARTS,$1) $(HW_COURSE)
	@mkdir -p $$(@D) && $$(CC) $$(STRICT) $$(OPENMP) $$(CFLAGS) -o $$@ $$^ -lm
endef
$(foreach f,$(HW_VARIANTS),$(eval $(call homework_rule,$f)))
check-homework: $(HW_CHECK) $(HW_COURSE) $(HW_VARIANTS:%.c=$(HW)/%/raytracer)
	@sh tests/tools/homework_check.sh $(HW) $(HW_CHECK) $(HW_COURSE) $(HW_BUILD)
homework-reference: $(HW)/reference $(HW)/solution $(HW_VARIANTS:%.c=$(HW)/%/raytracer)
	@sh tests/tools/homework_reference.sh $(HW) tests/homework/reference.pfm

# ---- the slides ------------------------------------------------------------------------
# Marp from npm makes HTML and PDF with chromium. Figures are drawn by a program of their own.
$B/slides-figures: $(patsubst %.c,$B/obj/%.o,$(wildcard slides/figures/*.c)) \
		$(call modules,11-fresnel) $(call solved,11-fresnel) $(COMMON)
	$(LINK)
slides/node_modules/.package-lock.json: slides/package-lock.json
	@command -v npm >/dev/null || { echo "slides: needs npm and chromium (see CONTRIBUTING.md)" >&2; exit 1; }
	@cd slides && PUPPETEER_SKIP_DOWNLOAD=1 npm ci --no-audit --no-fund --loglevel=error
.PHONY: slides check-slides
slides: $B/slides-figures slides/node_modules/.package-lock.json
	@mkdir -p build/slides/figures && $< build/slides/figures
	@sh slides/build.sh build/slides
	@echo "The decks: build/slides/en.html, en.pdf, sv.html, sv.pdf"
check-slides: slides
	@CHROME_PATH="$${CHROME_PATH:-$$(command -v chromium || command -v google-chrome)}" node slides/check.mjs build/slides

# ---- for those who work on the course ------------------------------------------------
SOURCES = $(wildcard slides/figures/*.[ch] common/*.[ch] tests/*.[ch] tests/tools/*.c tests/homework/*.[ch] tests/*/*/*.c chapters/*/*.[ch] exercises/*/*.c solutions/*/*.[ch])

check: test check-stubs check-variants check-homework check-complete check-staircase check-texts check-pictures check-slides check-format
	@echo "make check: all is well"

.PHONY: check-stubs check-variants check-complete check-staircase check-texts check-pictures check-format
check-stubs: $(ONE)
	@sh tests/tools/stubs.sh $^
check-variants: $(VARIANTS)
	@sh tests/tools/variants.sh $B $^
check-complete:
	@sh tests/tools/complete.sh $(CHAPTERS)
check-staircase:
	@sh tests/tools/staircase.sh
check-texts: error-tables
	@sh tests/tools/texts.sh check $(CHAPTERS)
check-pictures: $(CHAPTERS:%=$B/%) $B/same_picture
	@sh tests/tools/pictures.sh check $B README.md $(CHAPTERS:%=chapters/%/README.md)
check-format:
	@sh tests/tools/format.sh $(SOURCES)
$B/same_picture: $B/obj/tests/tools/same_picture.o
	$(LINK)

# The errors alone, in float and in double: the same to the digit everywhere. The programs are
# built before the inner makes start, or two makes would write the same objects at once.
.PHONY: error-tables
error-tables: $(CHAPTERS:%=$B/measure/%)
	@$(MAKE) -s --no-print-directory REAL=float $(CHAPTERS:%=build/errors/%.float.csv)
	@$(MAKE) -s --no-print-directory REAL=double $(CHAPTERS:%=build/errors/%.double.csv)
	@$(foreach c,$(CHAPTERS),cat build/errors/$c.float.csv build/errors/$c.double.csv > build/errors/$c.csv;)
build/errors/%.$(REAL).csv: $B/measure/%
	@mkdir -p $(@D)
	@ERRORS_ONLY=1 $< > $@.new 2> $@.log || { cat $@.log; exit 1; }
	@mv $@.new $@

.PHONY: soak
soak: $(patsubst %,$B/%,$(filter 09-% 10-% 11-%,$(CHAPTERS)))
	@sh tests/tools/soak.sh $(or $N,1e8) $^

# The OBJ reader and what it needs, in one program with libFuzzer.
FUZZ_CC ?= clang
FUZZED = tests/tools/fuzz_obj.c $(wildcard common/*.c chapters/12-bvh/obj*.c) $(filter-out %/main.c \
	%/measure.c,$(foreach c,$(UPTO_05-triangle),$(wildcard chapters/$c/*.c solutions/$c/*.c)))
.PHONY: fuzz
fuzz:
	@sh tests/tools/fuzz.sh "$(or $(SECONDS),60)" $B/fuzz_obj $(FUZZ_CC) $(STRICT) -Wno-unknown-pragmas $(STB_CFLAGS) $(FUZZED)
.PHONY: leaks
leaks: $B/test/12-bvh
	@LEAK_RAYS=$(or $N,1e8) TEST_SECONDS=86400 T="bvh_nearest: no leak" $<

texts: error-tables $(CHAPTERS:%=$B/%) $B/same_picture
	@sh tests/tools/texts.sh renew $(CHAPTERS)
	@sh tests/tools/pictures.sh renew $B README.md $(CHAPTERS:%=chapters/%/README.md)
format:
	clang-format -i $(SOURCES)
clean:
	rm -rf build

# ---- how an object is made -------------------------------------------------------------
$B/.setup:
	@sh tests/tools/setup.sh "$(CC)" "$(STB_CFLAGS)"
	@mkdir -p $B && touch $@
# A stub does not use its parameters yet.
$B/obj/%.o: %.c | $B/.setup
	$(COMPILE) $(if $(filter $(EXERCISES)/%,$*),-Wno-unused-parameter $(STOP)) -c -o $@ $<
$(OWN)/%.o: $(EXERCISES)/%.c | $B/.setup
	$(COMPILE) -Wno-unused-parameter $(STOP) -c -o $@ $<
$(OWN)/%.o:
	@echo "error: $(EXERCISES)/$*.c is missing" >&2; exit 1

-include $(wildcard $(HW)/obj/*/*/*.d $(HW)/obj/*/*/*/*.d $B/obj/*/*.d $B/obj/*/*/*.d $B/obj/*/*/*/*.d $(OWN)/*/*.d)
