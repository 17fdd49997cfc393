// The library: the scene's two functions and nothing that runs them.
