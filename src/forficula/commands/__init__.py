"""Commands of the command line; each one makes one call of the library.

Each command imports what it needs when it runs, so that help and errors do not wait for MuJoCo and matplotlib.
"""
