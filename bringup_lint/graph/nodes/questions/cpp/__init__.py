"""What C++ compiles and does not do as meant."""
