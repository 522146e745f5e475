# What to type: make build, make demo, make test. Each installs what is missing and does nothing twice.
# Everything is left under build/ (and web/dist, web/node_modules).

PROGRAM := build/playhouse
WEB_SOURCES := $(shell find web -path web/node_modules -prune -o -path web/dist -prune -o -type f -print 2>/dev/null)
# Of what codegen makes, the page's. It keeps its time where it does not change.
WEB_GENERATED := web/src/protocol/generated/commands.ts web/src/protocol/generated/views.ts
PLAYER_PORT ?= 6665
WEB_PORT ?= 8080
WORLD ?= worlds/cave.world
# The robot that a visitor drives: the cave's guest has no mind of its own; other worlds have a first one.
GUEST = $(if $(filter %cave.world,$(WORLD)),12,0)

.PHONY: core core-arm64 core-armhf core-powerpc help setup setup-test build demo test tsan fuzzers fuzz bench source clean web generated

help:
	@echo "make build   the release program, build/playhouse"
	@echo "make demo    the same, then $(WORLD) with a web page on $(WEB_PORT) and Player clients on $(PLAYER_PORT)"
	@echo "make test    every test: unit, law, compat, end to end, browser, fuzz smoke"
	@echo "make core    the device server alone, one static program; core-arm64, core-armhf, core-powerpc for other machines"
	@echo "make tsan    the tests again with the thread sanitizer: races"
	@echo "make bench   the benchmarks, one JSON line each"
	@echo "make fuzz    one minute of each fuzzer (FUZZ_SECONDS=60)"
	@echo "make source  an archive of the sources with what is generated, for machines without git and Python 3.11"
	@echo "make clean   remove build/ and web/dist"

setup:
	@tools/setup.sh build

setup-test:
	@tools/setup.sh test

web/node_modules/.installed: web/package-lock.json | setup
	@echo "== installing the web page's packages"
	cd web && npm ci --no-audit --no-fund --loglevel=error
	@touch $@

generated: setup
	@python3 -m codegen > /dev/null

$(WEB_GENERATED): generated ;

web/dist/index.html: web/node_modules/.installed $(WEB_SOURCES) $(WEB_GENERATED)
	@echo "== building the web page"
	cd web && npm run --silent build
	@touch $@

web: web/dist/index.html

build: setup web
	@echo "== building the program"
	@tools/configure.sh release
	@cmake --build --preset release --target playhouse
	@echo "== $(PROGRAM) is ready"

demo: build
	@echo
	@echo "  The robots of $(WORLD) are starting. While they run:"
	@echo "    look      http://127.0.0.1:$(WEB_PORT)/"
	@echo "    devices   $(PROGRAM) devices 127.0.0.1:$(PLAYER_PORT)"
	@echo "    scan      $(PROGRAM) watch 127.0.0.1:$(PLAYER_PORT) laser:0"
	@echo "    drive     $(PROGRAM) drive 127.0.0.1:$(PLAYER_PORT) position2d:$(GUEST)$(if $(filter 12,$(GUEST)),   (the guest: white))"
	@echo "    program   python3 clients/python/examples/wander.py 127.0.0.1:$(PLAYER_PORT) $(GUEST)"
	@echo "  Ctrl-C ends it."
	@echo
	@$(PROGRAM) run $(WORLD) --port $(PLAYER_PORT) --web $(WEB_PORT)

# The device server alone (docs/small.md), at build/PRESET/bin/player.
core:
	@tools/setup.sh core
	@tools/configure.sh core
	@cmake --build --preset core --target player

core-arm64 core-armhf core-powerpc:
	@tools/setup.sh cross
	@tools/configure.sh $@
	@cmake --build --preset $@ --target player

fuzzers: setup-test web
	@echo "== building the fuzzers"
	@tools/configure.sh ci
	@cmake --build --preset ci --target fuzzers

test: setup-test
	@tools/test.sh

tsan: setup-test web
	@tools/tsan.sh

fuzz: fuzzers
	@tools/fuzz.sh $${FUZZ_SECONDS:-60}

bench: build
	@tools/bench.sh

source: generated
	@tools/source.sh

clean:
	rm -rf build web/dist
