# Debian 12 with what the README's commands need, and the program, for who has another system:
#
#   docker build -t ldm .
#   docker run --rm -v "$PWD/results:/ldm/results" ldm make reproduce
#   docker run --rm ldm make test
FROM debian:bookworm
RUN apt-get update && apt-get install -y --no-install-recommends make
WORKDIR /ldm
COPY . .
RUN make setup
RUN make program
CMD ["make"]
