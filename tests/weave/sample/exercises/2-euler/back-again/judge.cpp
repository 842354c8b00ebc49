// The tests.
