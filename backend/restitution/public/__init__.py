"""What `import restitution` has beside classes: its functions, by what they are about."""
