"""What notes and report must say of balancing and of banks, sentence by sentence, by the analysis alone (пояснения)."""
